#include <gtest/gtest.h>

#include "support/column_run.hpp"

/// A column on a base of limited friction: it slides where the base does not hold it, and sticks where it does.
namespace {

using namespace talus;

constexpr double slope = 45.0, thickness = 0.002;

column::Parameters on_base(double mu_b, int layers = 40) {
  auto par = tests::table_2(slope, thickness, layers);
  par.wall.u_c = 1e-5;
  par.regularisation = {.eta_max = 1e4, .cap = rheology::Cap::smooth};  // a plug is rigid without a cap
  par.box.base_friction = mu_b;
  return par;
}

double mean_speed(const tests::ColumnRun& run) { return run.flow() / thickness; }

/// Newton's law for the layer as a whole: weight less walls, mu_w H/W of the pressure on the base, less the base, mu_b of it.
TEST(SlidingColumn, GainsSpeedByWhatWallsAndBaseLeaveOfItsWeight) {
  for (const double mu_b : {0.1, 0.3, 0.5}) {
    const auto par = on_base(mu_b);
    tests::ColumnRun run(par, tests::precise());
    run.at(0.5);
    const double before = mean_speed(run);
    run.at(1.0);
    const double zeta = slope * tests::degree;
    const double expected = 9.81 * (std::sin(zeta) - std::cos(zeta) * (par.wall.mu_w * thickness / par.box.gap + mu_b));
    EXPECT_NEAR((mean_speed(run) - before) / 0.5, expected, 1e-4 * expected) << mu_b;
    const double pressure = par.grains.rho() * 9.81 * std::cos(zeta) * thickness;
    EXPECT_NEAR(column::forces(run.column(), 1.0, run.u()).base_stress, -mu_b * pressure, 1e-4 * pressure);
  }
}

/// The base must hold tan zeta - mu_w H/W = 0.752 of the pressure. A much rougher one is one to which grains stick.
TEST(SlidingColumn, SticksToARoughBase) {
  auto sticking = on_base(1.0);
  sticking.box.base_friction.reset();
  tests::ColumnRun stuck(sticking, tests::precise()), rough(on_base(1e3), tests::precise()),
      less(on_base(3.0), tests::precise());
  for (auto* run : {&stuck, &rough, &less}) run->at(1.0);
  EXPECT_NEAR(mean_speed(rough), mean_speed(stuck), 1e-7 * mean_speed(stuck));
  EXPECT_NEAR(mean_speed(less), mean_speed(stuck), 0.01 * mean_speed(stuck));
  EXPECT_GT(mean_speed(less), mean_speed(stuck));
}

/// A base that would just hold the layer lets it creep by a smooth law; what that adds vanishes with the layers' thickness.
TEST(SlidingColumn, HoldsWhatIsBelowItsFrictionOnFineGrids) {
  auto sticking = on_base(1.0, 160);
  sticking.box.base_friction.reset();
  tests::ColumnRun stuck(sticking, tests::precise());
  stuck.at(2.0);
  double off[3];
  for (int i = 0; i < 3; ++i) {
    tests::ColumnRun run(on_base(0.9, 40 << i), tests::precise());
    run.at(2.0);
    off[i] = mean_speed(run) / mean_speed(stuck) - 1.0;
    std::printf("%d layers: %.4f %% faster\n", 40 << i, 100.0 * off[i]);
  }
  EXPECT_GT(off[0], off[1]);
  EXPECT_NEAR(off[1] / off[0], 0.5, 0.15);
  EXPECT_NEAR(off[2] / off[1], 0.5, 0.15);
}

}  // namespace
