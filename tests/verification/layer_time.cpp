#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "support/held_step.hpp"
#include "support/layer_cases.hpp"
#include "support/table.hpp"

/// Time on a fixed grid: a small layer of grains between walls, every regularisation smooth, pushed from rest into waves. Errors
/// against the same semi-discrete system solved far more closely, for velocities, pressure and thickness apart.
namespace {

using namespace talus;

constexpr double end = 0.4;  // [s]
constexpr int n_outputs = 10;

/// `atol`: absolute tolerance of velocities [m/s]; those of thickness and pressure follow their sizes.
layer::Parameters level_layer(double atol) {
  auto par = tests::periodic_layer(0.06, 0.02, 0.0, 8, 6);
  par.law = tests::table_2_classical();  // the other law has a kink in its slope at I_N
  par.regularisation = {
      .p_0 = 20.0, .rate_floor = 10.0, .rate_speed = 0.0, .eta_max = 20.0, .cap = rheology::Cap::smooth};
  par.wall = {.mu_w = 0.1, .u_c = 0.5};
  par.numerics.advection = layer::Advection::central;
  par.numerics.jump_from = 1.0;  // the donor flux of steep fronts is C1 only
  par.numerics.jump_to = 2.0;
  par.atol_velocity = atol;
  par.atol_height = 0.02 * atol;
  par.atol_pressure = 1e3 * atol;
  return par;
}

/// A layer at rest under a level surface, pushed along x by a force that is uneven in x, and in time a bump whose first five
/// derivatives are zero at the start: the first steps, at orders below the one under test, then leave no trace.
class PushedLayer final : public core::DaeSystem {
 public:
  explicit PushedLayer(const layer::Parameters& par) : layer_(par) {}

  [[nodiscard]] const core::Layout& layout() const override { return layer_.layout(); }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return layer_.pattern(); }
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override {
    layer_.initial_state(t, y, yp);
  }
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override {
    layer_.residual(t, y, yp, r);
    const auto& c = layer_.columns();
    const auto& par = layer_.parameters();
    const double push = 3.0 * std::pow(std::sin(std::numbers::pi * t / end), 6);  // [m/s2]
    const double mass = par.grains.rho() * par.initial.thickness / c.n_layers;
    for (int f = 0; f < c.n_faces(); ++f) {
      const double uneven = 1.0 + std::cos(2.0 * std::numbers::pi * c.x_face(f) / c.length);
      for (int k = 0; k < c.n_layers; ++k) r[layer_.unknowns().momentum_u(f, k)] -= mass * push * uneven;
    }
  }
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override {
    layer_.jacobian(t, y, yp, c_j, values);
  }
  [[nodiscard]] std::string describe(core::Index row) const override { return layer_.describe(row); }

 private:
  layer::Layer layer_;
};

using States = std::vector<std::vector<double>>;

/// The states at n_outputs equidistant times.
States run(const core::DaeSystem& system, const ida::Options& options, core::Observer& observer,
           core::Statistics* statistics = nullptr) {
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  ida::Ida integrator(system, options);
  integrator.start(0.0, y, yp);
  States states;
  for (int i = 1; i <= n_outputs; ++i) {
    integrator.advance(end * i / n_outputs, observer);
    states.emplace_back(integrator.current().y.begin(), integrator.current().y.end());
  }
  if (statistics) *statistics = integrator.current().statistics;
  return states;
}

/// Largest error of each kind of unknown over the output times, as a share of its largest value.
struct Errors {
  double velocity = 0.0, pressure = 0.0, thickness = 0.0;
};

Errors errors(const core::DaeSystem& system, const States& states, const States& reference) {
  Errors size, error;
  for (std::size_t s = 0; s < states.size(); ++s) {
    for (core::Index i = 0; i < system.layout().size(); ++i) {
      const auto& name = system.layout().field(i).name;
      const auto of = [&](Errors& e) -> double& {
        return name == "p" ? e.pressure : name == "H" ? e.thickness : e.velocity;
      };
      of(size) = std::max(of(size), std::abs(reference[s][i]));
      of(error) = std::max(of(error), std::abs(states[s][i] - reference[s][i]));
    }
  }
  return {error.velocity / size.velocity, error.pressure / size.pressure, error.thickness / size.thickness};
}

/// Tolerances so loose that no step is ever too long, and a Newton iteration that ends near rounding.
ida::Options held(int order, double step) { return tests::held_step(order, step, 1.0 - 1e-9, 1e-11); }

TEST(LayerTime, EachFormulaHasItsOrder) {
  const PushedLayer system(level_layer(1e-2));
  core::Observer nobody;
  const auto reference = run(system, held(5, end / 1280), nobody);
  tests::Table table("layer_time_order", {"order", "step [s]", "error of u, w", "error of p", "error of H",
                                          "order of u, w", "order of p", "order of H"});
  for (int order = 1; order <= 5; ++order) {
    std::vector<double> steps, u, p, H;
    for (const int n : {40, 80, 160, 320}) {
      const double step = end / n;
      tests::HeldStepObserver observer(order, step, [](const core::Snapshot&) {});
      const auto e = errors(system, run(system, held(order, step), observer), reference);
      EXPECT_EQ(observer.n_lost, 0) << "order " << order << ", step " << step;
      EXPECT_GT(observer.n_held, n - 8) << "order " << order << ", step " << step;
      steps.push_back(step);
      u.push_back(e.velocity);
      p.push_back(e.pressure);
      H.push_back(e.thickness);
      const auto latest = [&](const std::vector<double>& of) {
        return steps.size() == 1 ? tests::Table::Cell("") : diagnostics::observed_orders(steps, of).back();
      };
      table.row({double(order), step, e.velocity, e.pressure, e.thickness, latest(u), latest(p), latest(H)});
    }
    EXPECT_NEAR(diagnostics::observed_orders(steps, u).back(), order, 0.3) << "velocity, order " << order;
    EXPECT_NEAR(diagnostics::observed_orders(steps, p).back(), order, 0.3) << "pressure, order " << order;
    EXPECT_NEAR(diagnostics::observed_orders(steps, H).back(), order, 0.3) << "thickness, order " << order;
  }
}

TEST(LayerTime, ErrorFollowsTheTolerance) {
  core::Observer nobody;
  const auto reference = run(PushedLayer(level_layer(1e-2)), held(5, end / 1280), nobody);
  tests::Table table("layer_time_tolerance", {"rtol", "error of u, w", "error of p", "error of H", "u, w over rtol",
                                              "p over rtol", "steps", "Newton fails", "factorisations"});
  std::vector<double> tolerances, u, p;
  for (const double rtol : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    const PushedLayer system(level_layer(rtol));
    ida::Options options;
    options.rtol = rtol;
    core::Statistics statistics;
    const auto e = errors(system, run(system, options, nobody, &statistics), reference);
    table.row({rtol, e.velocity, e.pressure, e.thickness, e.velocity / rtol, e.pressure / rtol,
               double(statistics.steps), double(statistics.newton_failures), double(statistics.factorisations)});
    tolerances.push_back(rtol);
    u.push_back(e.velocity);
    p.push_back(e.pressure);
    EXPECT_EQ(statistics.newton_failures, 0) << rtol;
  }
  EXPECT_NEAR(diagnostics::fitted_order(tolerances, u), 0.9, 0.15);
  EXPECT_NEAR(diagnostics::fitted_order(tolerances, p), 0.9, 0.15);
  EXPECT_LT(u.back(), 300.0 * tolerances.back());
  EXPECT_LT(p.back(), 30.0 * tolerances.back());
}

}  // namespace
