#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>

#include "core/sums.hpp"
#include "layer/layer.hpp"
#include "linear/direct_solver.hpp"
#include "support/layer_cases.hpp"

/// What one step of the heap is made of, at 300x32 and a quarter and four times as many columns: residual, exact Jacobian, factors
/// and a solve, beside one pass over the residual's arrays. The state is like a heap's: a ridge that flows near its surface.
namespace {
using namespace talus;

layer::Parameters heap(int columns) {
  auto par = tests::periodic_layer(0.6, 0.001, 29.2 * std::numbers::pi / 180.0, columns, 32);
  par.box.height = 0.3;
  par.box.periodic = false;
  par.box.left_open = par.box.right_open = true;
  par.regularisation = {0.01, 0.0, 0.01, 1e4, rheology::Cap::smooth};
  par.wall = {.mu_w = 0.3727, .u_c = 5e-4};
  par.inflow.rate = 0.0046;
  par.inflow.position = 0.11;
  par.inflow.width = 0.008;
  par.grid.cluster_depth = 0.003;
  return par;
}

struct Heap {
  explicit Heap(int columns) : system(heap(columns)), y(system.layout().size()), yp(y), r(y) {
    system.initial_state(1.0, y, yp);
    const auto& c = system.columns();
    const auto& number = system.unknowns();
    const auto& par = system.parameters();
    for (int i = 0; i < c.n_columns; ++i) {
      const double x = c.x_centre(i);
      y[number.H(i)] = 0.002 + 0.09 * std::exp(-std::pow((x - 0.2) / 0.12, 2));
    }
    const auto& context = system.context(1.0, y);
    const double weight = par.grains.rho() * par.box.gravity * std::cos(par.box.tilt);
    for (int i = 0; i < c.n_columns; ++i)
      for (int k = 0; k < c.n_layers; ++k) {
        const double depth = y[number.H(i)] - 0.5 * (context.z[context.at(i, k)] + context.z[context.at(i, k + 1)]);
        y[number.p(i, k)] = weight * depth;
        y[number.u(i, k)] = 0.3 * std::exp(-depth / 0.004);
        y[number.omega(i, k + 1)] = 1e-4 * std::sin(i + k);
      }
    values.resize(system.pattern().n_nonzeros());
    system.jacobian(1.0, y, yp, 100.0, values);
    solver = linear::make_solver(system.pattern(), {.choice = linear::Choice::condensed, .accuracy = 1e-6});
    solver->factor(values);
    system.residual(1.0, y, yp, r);
    solver->solve(r);  // the first is the test of the factors
  }

  layer::Layer system;
  std::vector<double> y, yp, r, values;
  std::unique_ptr<linear::DirectSolver> solver;
};

Heap& heap_of(int columns) {
  static std::map<int, std::unique_ptr<Heap>> heaps;
  auto& heap = heaps[columns];
  if (!heap) heap = std::make_unique<Heap>(columns);
  return *heap;
}

void residual(benchmark::State& state) {
  auto& h = heap_of(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) h.system.residual(1.0, h.y, h.yp, h.r);
}
void jacobian(benchmark::State& state) {
  auto& h = heap_of(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) h.system.jacobian(1.0, h.y, h.yp, 100.0, h.values);
}
void factor(benchmark::State& state) {
  auto& h = heap_of(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) h.solver->factor(h.values);
}
void solve(benchmark::State& state) {
  auto& h = heap_of(static_cast<int>(state.range(0)));
  h.solver->factor(h.values);
  h.solver->solve(h.r);
  for ([[maybe_unused]] auto _ : state) {
    std::fill(h.r.begin(), h.r.end(), 1.0);
    h.solver->solve(h.r);
  }
}
/// Reads y, y', the geometry (four numbers an interface) and the numbers of all inputs and rows that the terms hold, 144 a cell, and writes r.
void stream(benchmark::State& state) {
  auto& h = heap_of(static_cast<int>(state.range(0)));
  const auto n_cells = static_cast<std::size_t>(state.range(0)) * 32;
  const std::vector<std::int32_t> numbers(n_cells * 144, 1);
  const std::vector<double> geometry(n_cells * 4, 1.0);
  for ([[maybe_unused]] auto _ : state) {
    std::int32_t sum = 0;
    for (const auto number : numbers) sum += number;
    const double size = core::sum_of(0, geometry.size(), [&](auto read, std::size_t i) { return read(&geometry[i]); });
    for (std::size_t i = 0; i < h.r.size(); ++i) h.r[i] = h.y[i] + h.yp[i];
    benchmark::DoNotOptimize(sum);
    benchmark::DoNotOptimize(size);
    benchmark::DoNotOptimize(h.r.data());
  }
}

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(75)->Arg(300)->Arg(1200)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}
BENCHMARK(residual)->Name("layer residual, 32 layers, columns")->Apply(sizes);
BENCHMARK(jacobian)->Name("layer Jacobian, 32 layers, columns")->Apply(sizes);
BENCHMARK(factor)->Name("layer factors, 32 layers, columns")->Apply(sizes);
BENCHMARK(solve)->Name("layer solve, 32 layers, columns")->Apply(sizes);
BENCHMARK(stream)->Name("layer arrays streamed once, 32 layers, columns")->Apply(sizes);
}  // namespace
