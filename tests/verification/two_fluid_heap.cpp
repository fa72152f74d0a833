#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/two_fluid_model.hpp"
#include "ida/ida.hpp"
#include "support/table.hpp"
#include "two_fluid/cell_state.hpp"
#include "two_fluid/two_fluid.hpp"

/// The first seconds of the heap by two fluids, on cells of 10 mm: that it holds together, not that it is resolved.
namespace {

using namespace talus;

/// That class, C, nu, q and growth of the grains in a cell say the same.
void expect_one_class(const two_fluid::CellState& s) {
  using enum diagnostics::FlowClass;
  EXPECT_NEAR(s.C, s.q * s.q - 4.0 * s.nu * (1.0 - s.nu), 1e-12);
  EXPECT_EQ(s.flow_class == capped, s.capped);
  EXPECT_EQ(s.flow_class == well_posed, !s.capped && s.C <= 0.0);
  EXPECT_EQ(s.flow_class == ill_posed, s.growth_per_k2 > 0.0);
}

TEST(TwoFluidHeap, GathersUnderTheJetAndKeepsItsMass) {
  const auto scene = app::read_scene(TALUS_SOURCE_DIR "/runs/benchmarks/two_fluid_heap.toml");
  const two_fluid::TwoFluid system(app::make_two_fluid_parameters(scene));
  const auto& at = system.unknowns();
  const auto& g = system.mesh().grid();
  std::vector<double> y(system.layout().size()), yp(y);
  core::Observer nobody;
  system.initial_state(0.0, y, yp);
  const auto options = app::make_integrator_options(scene);
  ida::Ida integrator(system, options);
  integrator.start(0.0, y, yp);
  tests::Table table("two_fluid_heap", {"t [s]", "stored [g]", "dense [g]", "left the box [g]", "highest [mm]",
                                        "phi below 0", "phi above 1", "steps", "factorisations"});
  double highest_before = 0.0;
  for (const double t : {2.0, 4.0, 6.0}) {
    integrator.advance(t, nobody);
    const auto now = integrator.current();
    double stored = 0.0, dense = 0.0, highest = 0.0, least = 0.0, most = 1.0;
    for (const auto [i, k] : system.mesh().cells()) {
      const double phi = now.y[at.phi(i, k)];
      const double mass = phi * g.dx(i) * g.dz(k) * system.context(t).grains_across();
      stored += mass;
      if (phi > two_fluid::dense) {
        dense += mass;
        expect_one_class(two_fluid::cell_state(system, system.context(t), now.y, i, k));
      }
      least = std::min(least, phi), most = std::max(most, phi);
    }
    for (int i = 0; i < g.n_columns(); ++i) highest = std::max(highest, two_fluid::heap_height(system, now.y, i));
    const double gone = now.y[at.mass_left()] + now.y[at.mass_right()] + now.y[at.mass_top()];
    table.row({t, 1e3 * stored, 1e3 * dense, 1e3 * gone, 1e3 * highest, -least, most - 1.0,
               double(now.statistics.steps), double(now.statistics.factorisations)});
    // Rows of masses sum to nothing; factors in single precision solve them to some 1e-7 of a correction.
    EXPECT_NEAR(stored + gone, now.y[at.mass_in()], 1e-10 * now.y[at.mass_in()]);
    EXPECT_NEAR(now.y[at.mass_in()], 0.0046 * (t - 0.1), 5e-5);  // half the ramp is lost
    EXPECT_LT(gone, 0.1 * stored);
    EXPECT_GT(highest, highest_before);
    EXPECT_GE(least, -1e-6);
    EXPECT_LE(most, 1.0 + 1e-6);
    highest_before = highest;
  }
  EXPECT_GT(highest_before, 0.025);
}

}  // namespace
