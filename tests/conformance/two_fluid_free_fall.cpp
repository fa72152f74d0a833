#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/two_fluid.hpp"

/// What the two-fluid model promises of grains that fall freely onto the heap, `two_fluid.jet = "free_fall"`.
namespace {

using namespace talus;
using tests::heap_of_two_fluids, tests::Settings;
using two_fluid::TwoFluid;

/// Lines of fall are straight along gravity, without gaps, through cells that hold them, from the base to the inlet.
TEST(TwoFluidFreeFall, LinesOfFallLeadFromTheInletToTheBase) {
  for (const Settings& settings : {Settings{},
                                   {"two_fluid.x_grading=3", "two_fluid.z_grading=0.3"},
                                   {"box.tilt=-20", "inflow.position=0.4"},
                                   {"box.tilt=0"}}) {
    Settings all = settings;
    all.emplace_back("two_fluid.jet=free_fall");
    const TwoFluid system(heap_of_two_fluids(23, 17, all));
    const auto& g = system.mesh().grid();
    const auto& par = system.parameters();
    const auto& fall = system.mesh().fall();
    const double inlet = std::sqrt(12.0) * par.inflow.width, tilt = par.box.tilt;
    ASSERT_GE(fall.n_lines, 4);
    double before = 0.0, x_mean = 0.0;
    for (const auto& s : fall.steps) {
      if (s.lowest) {
        EXPECT_EQ(s.from, 0.0);
        EXPECT_EQ(s.k, 0);
      } else {
        EXPECT_EQ(s.from, before);
      }
      before = s.to;
      const double z = par.box.height - s.drop * std::cos(tilt);
      const double x = par.inflow.position + inlet * ((s.line + 0.5) / fall.n_lines - 0.5) + s.drop * std::sin(tilt);
      EXPECT_TRUE(x > g.x_nodes[s.i] && x < g.x_nodes[s.i + 1] && z > g.z_nodes[s.k] && z < g.z_nodes[s.k + 1]);
      if (!s.highest) continue;
      EXPECT_EQ(s.k, g.n_layers() - 1);
      EXPECT_NEAR(s.to, par.box.height / std::cos(tilt), 1e-14);
      x_mean += x / fall.n_lines;
    }
    EXPECT_NEAR(x_mean, par.inflow.position, 0.05);
    EXPECT_EQ(std::ranges::count_if(fall.steps, [](const auto& s) { return s.highest; }), fall.n_lines);
  }
}

/// Wherever the heap ends, all that is poured enters the cells, within the clearance above it, with the momentum of its fall.
TEST(TwoFluidFreeFall, WhatFallsFreelyEntersAboveTheHeapWithItsMomentum) {
  const TwoFluid system(heap_of_two_fluids(60, 30, {"two_fluid.jet=free_fall"}));
  const auto& at = system.unknowns();
  const auto& par = system.parameters();
  const auto& fall = system.mesh().fall();
  const auto context = system.context(10.0);
  const double clearance = par.numerics.jet_clearance, tilt = par.box.tilt, length = par.box.height / std::cos(tilt);
  std::vector<double> y(system.layout().size(), 0.0), yp(y), r(y), before(y);
  for (const double H : {-0.015, 0.03, 0.0333, 0.1, 0.2}) {
    for (int line = 0; line < at.n_heaps(); ++line) y[at.heap(line)] = H;
    system.residual(0.0, y, yp, before);  // nothing is poured yet
    system.residual(10.0, y, yp, r);
    std::set<core::Index> within;
    for (const auto& s : fall.steps)
      if (s.to > H && s.from < H + clearance) within.insert(at.phi(s.i, s.k));
    double volume = 0.0, along = 0.0, up = 0.0;
    for (const auto [i, k] : system.mesh().cells()) {
      const double enters = before[at.phi(i, k)] - r[at.phi(i, k)];
      volume += enters;
      EXPECT_EQ(enters > 0.0, within.contains(at.phi(i, k))) << i << ' ' << k << ' ' << H;
      EXPECT_EQ(enters, before[at.continuity(i, k)] - r[at.continuity(i, k)]);
    }
    for (const auto [f, k] : system.mesh().faces()) along += before[at.momentum_u(f, k)] - r[at.momentum_u(f, k)];
    for (const auto [i, k] : system.mesh().interfaces()) up += before[at.momentum_w(i, k)] - r[at.momentum_w(i, k)];
    EXPECT_NEAR(volume, context.poured, 1e-15);
    EXPECT_NEAR(before[at.mass_in()] - r[at.mass_in()], 0.0046, 1e-15);
    if (H < 0.0) continue;  // the base takes some of the momentum
    EXPECT_NEAR(up / along, -1.0 / std::tan(tilt), 1e-12);
    const double speed = std::hypot(along, up) / (par.grains.rho() * volume), g = par.box.gravity;
    EXPECT_GT(speed, std::sqrt(2.0 * g * (length - H - clearance)));
    EXPECT_LT(speed, std::sqrt(2.0 * g * (length - H) + std::pow(context.inlet_speed / std::cos(tilt), 2)));
  }
}

/// The height along each line is the length that grains have of it.
TEST(TwoFluidFreeFall, TheHeightOnALineIsWhatGrainsHaveOfIt) {
  const TwoFluid system(heap_of_two_fluids(30, 15, {"two_fluid.jet=free_fall", "model.initial_thickness=0.08"}));
  const auto& at = system.unknowns();
  std::vector<double> y(system.layout().size()), yp(y), r(y);
  system.initial_state(0.0, y, yp);
  const double height = 0.08 / std::cos(system.parameters().box.tilt);
  for (int line = 0; line < at.n_heaps(); ++line) EXPECT_NEAR(y[at.heap(line)], height, 1e-12);
  system.residual(0.0, y, yp, r);
  for (int line = 0; line < at.n_heaps(); ++line) EXPECT_NEAR(r[at.heap(line)], 0.0, 1e-12);
}

}  // namespace
