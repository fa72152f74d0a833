#include <gtest/gtest.h>

#include <cmath>

#include "app/two_fluid_model.hpp"
#include "ida/ida.hpp"
#include "support/example_scene.hpp"
#include "support/table.hpp"
#include "two_fluid/grain_flux.hpp"
#include "two_fluid/two_fluid.hpp"

/// The dilute jet alone, figure 11 of the paper.
namespace {

using namespace talus;

/// Mass flow of grains down through interface k [kg/s], by the flux of the equations.
double flow_through(const two_fluid::TwoFluid& system, std::span<const double> y, double t, int k) {
  const auto& at = system.unknowns();
  const auto& g = system.mesh().grid();
  const auto context = system.context(t);
  double sum = 0.0;
  for (int i = 0; i < g.n_columns(); ++i) {
    std::array<double, 4> phi{};
    for (int j = 0; j < 4; ++j) phi[j] = fv::read(y, at.phi(i, k - 2 + j));
    sum -= g.dx(i) * two_fluid::grain_flux_z(context, i, k, fv::read(y, at.w(i, k)),
                                             two_fluid::Row<double>{phi[0], phi[1], phi[2], phi[3]},
                                             fv::read(y, at.heap()));
  }
  return sum * context.grains_across();
}

TEST(TwoFluidJet, CarriesTheInflowThroughEachSection) {
  const auto scene = tests::small("two_fluid_jet", 20, 60);
  const two_fluid::TwoFluid system(app::make_two_fluid_parameters(scene));
  std::vector<double> y(system.layout().size()), yp(y);
  core::Observer nobody;
  system.initial_state(0.0, y, yp);
  ida::Ida integrator(system, app::make_integrator_options(scene));
  integrator.start(0.0, y, yp);
  integrator.advance(scene.end, nobody);
  const auto now = integrator.current();
  const auto& at = system.unknowns();
  const auto& g = system.mesh().grid();
  const double start = system.context(now.t).inlet_speed;
  tests::Table table("two_fluid_jet", {"height [m]", "flow [g/s]", "mean speed [m/s]", "free fall [m/s]", "phi [1]"});
  for (int k = 60; k >= 4; k -= 4) {
    double carried = 0.0, width = 0.0,
           densest = 0.0;  // of the grains in the layer above the section, the inlet for the uppermost
    for (int i = 0; i < 20; ++i) {
      const double phi = k == 60 ? 0.2 * system.mesh().inlet_share(i) : now.y[at.phi(i, k)];
      const double w = k == 60 ? start : -now.y[at.w(i, k)];
      carried += phi * w, width += phi;
      densest = std::max(densest, phi);
    }
    const double fall = std::sqrt(start * start + 2.0 * 9.81 * (g.z_nodes[60] - g.z_nodes[k]));
    const double flow = flow_through(system, now.y, now.t, k), speed = carried / width;
    table.row({g.z_nodes[k], 1e3 * flow, speed, fall, densest});
    EXPECT_NEAR(flow, 0.0046, 0.005 * 0.0046) << g.z_nodes[k];
    if (k > 52 || k < 8) continue;  // the inlet's corner, and the splash on the base
    EXPECT_LT(speed, fall) << g.z_nodes[k];
    EXPECT_GT(speed, 0.88 * fall) << g.z_nodes[k];  // the air that it drags along slows it
  }
  for (const auto [i, k] : system.mesh().cells()) {
    ASSERT_GE(now.y[at.phi(i, k)], -1e-6) << system.describe(at.phi(i, k));
    ASSERT_LE(now.y[at.phi(i, k)], 0.2 + 1e-6) << system.describe(at.phi(i, k));
  }
}

}  // namespace
