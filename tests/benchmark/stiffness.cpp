#include <benchmark/benchmark.h>

#include <cmath>

#include "arkode/arkode.hpp"
#include "support/column_run.hpp"

/// What the cap eta_max costs: a column of 12 layers of 1 mm from rest at 20 degrees, 0.25 s, by an explicit method (order 4) and by
/// BDF, each at rtol 1e-4. Under the classical law it stays at rest, where it is as stiff as the cap. The argument is log10 of eta_max
/// [Pa s].
namespace {
using namespace talus;

struct Silent final : core::Observer {};

template <class Integrator>
void column_from_rest(benchmark::State& state) {
  constexpr double end = 0.25;  // [s]
  auto parameters = tests::table_2(20.0, 0.012, 12, 0.0);
  parameters.law = rheology::classical(0.4, 0.9, 1.3);
  parameters.regularisation.eta_max = std::pow(10.0, static_cast<double>(state.range(0)));
  parameters.regularisation.cap = rheology::Cap::smooth;
  parameters.atol_velocity = 1e-6;
  const column::Column column(parameters);
  std::vector<double> y(column.layout().size()), yp(y);
  column.initial_state(0.0, y, yp);
  for ([[maybe_unused]] auto _ : state) {
    Integrator integrator(column);
    Silent observer;
    integrator.start(0.0, y, yp);
    integrator.advance(end, observer);
    const auto reached = integrator.current();
    state.counters["steps"] = static_cast<double>(reached.statistics.steps);
    state.counters["residuals"] = static_cast<double>(reached.statistics.residuals);
    state.counters["surface_speed"] = reached.y.back();
  }
}

BENCHMARK(column_from_rest<arkode::Arkode>)
    ->Name("column, explicit Runge-Kutta, eta_max 1e")
    ->DenseRange(0, 4)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(column_from_rest<ida::Ida>)
    ->Name("column, BDF, eta_max 1e")
    ->DenseRange(0, 8)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
}  // namespace
