#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "support/example_scene.hpp"
#include "support/scene_run.hpp"

/// Parameters at their extremes, one at a time, on small grids: a choice of what `runs/studies/extremes.py` runs in full.
namespace {

using namespace talus;
using Settings = std::vector<std::string>;

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

/// A test's name from what it sets first.
std::string named(const testing::TestParamInfo<Settings>& each) {
  std::string name = std::to_string(each.index) + "_";
  for (const char c : each.param.front()) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

double top_speed(const tests::SceneRun& run) { return run.field("u").back(); }

/// How long a uniform flow stays uniform [s]. Under a cap of 0.01 Pa s, or of grains of a micrometre, it is nearly inviscid and not
/// stable: waves as long as the box grow from round-off at some 50 1/s once the surface moves at 2 m/s, alike at rtol 1e-5, 1e-6, 1e-7
/// (under the cap also at every order of BDF), and are of the size of the flow at 0.7 to 1 s. Steps that do not resolve them damp them.
double stays_uniform(const Settings& settings) {
  const bool nearly_inviscid = settings.front() == "rheology.eta_max=1e-2" || settings.front() == "grains.d=1e-6";
  return nearly_inviscid ? 0.3 : 2.0;
}

class Uniform : public testing::TestWithParam<Settings> {};

TEST_P(Uniform, LayerFollowsTheColumn) {
  const Settings column = with(GetParam(), {"model.name=column", "output.times=[]", "time.end=2"});
  const Settings layer = with(GetParam(), {"model.name=layer", "output.times=[]", "time.end=2"});
  tests::SceneRun one(tests::small("chute_periodic", 3, 16, column)), two(tests::small("chute_periodic", 3, 16, layer));
  for (const double t : {0.1, stays_uniform(GetParam())}) {
    one.advance(t);
    two.advance(t);
    EXPECT_NEAR(top_speed(two), top_speed(one), 1e-3 * std::abs(top_speed(one)) + 1e-5) << "at " << t << " s";
  }
  EXPECT_TRUE(std::isfinite(top_speed(one)));
  EXPECT_EQ(one.current().statistics.newton_failures, 0);
}

INSTANTIATE_TEST_SUITE_P(Scales, Uniform,
                         testing::Values(Settings{"rheology.eta_max=1e-2"},
                                         Settings{"rheology.eta_max=1e12", "rheology.cap=smooth"},
                                         Settings{"rheology.p_0=1e3"}, Settings{"wall.u_c=1e-8"},
                                         Settings{"wall.u_c=1"}, Settings{"box.tilt=0"}, Settings{"box.tilt=89"},
                                         Settings{"box.gap=1e-4"}, Settings{"box.gap=100"}, Settings{"grains.d=1e-6"},
                                         Settings{"grains.d=0.1"}, Settings{"box.gravity=1e-3"},
                                         Settings{"box.gravity=1e3"}, Settings{"integrator.max_order=1"},
                                         Settings{"grains.rho_star=2.5e9", "rheology.eta_max=1e9", "rheology.p_0=1e4",
                                                  "integrator.atol_pressure=1e5"}),
                         named);

class Heap : public testing::TestWithParam<Settings> {};

TEST_P(Heap, LosesNoMass) {
  tests::SceneRun run(tests::small("heap_q46", 24, 8, with(GetParam(), {"output.times=[]", "time.end=3"})));
  run.advance(3.0);
  EXPECT_NEAR(run.number("mass_error"), 0.0, 1e-10 * run.number("mass_stored"));
  EXPECT_TRUE(std::isfinite(run.largest("surface_speed")));
}

INSTANTIATE_TEST_SUITE_P(Scales, Heap,
                         testing::Values(Settings{"rheology.eta_max=1e12"}, Settings{"rheology.p_0=1e3"},
                                         Settings{"wall.u_c=1"}, Settings{"box.tilt=0"}, Settings{"box.gap=100"},
                                         Settings{"inflow.rate=0"}, Settings{"inflow.rate=0.01"},
                                         Settings{"model.initial_thickness=0.29"}, Settings{"integrator.rtol=1e-1"},
                                         Settings{"integrator.max_order=1"}),
                         named);

std::string refusal(const Settings& settings) {
  try {
    (void)tests::small("heap_q46", 24, 8, settings);
  } catch (const core::ConfigError& error) { return error.what(); }
  return "accepted";
}

TEST(Extremes, WhatTheModelCannotRepresentIsRefusedByKey) {
  for (const auto& [setting, key] :
       {std::pair{"model.initial_thickness=0.3", "model.initial_thickness: expected below box.height"},
        std::pair{"box.tilt=60", "inflow.position: the jet meets the base at"},
        std::pair{"box.tilt=90", "box.tilt: expected"}, std::pair{"rheology.eta_max=0", "rheology.eta_max: expected"},
        std::pair{"integrator.max_order=6", "integrator.max_order: expected"},
        std::pair{"inflow.times=[1, 2]", "inflow.shares"}})
    EXPECT_NE(refusal({setting}).find(key), std::string::npos) << setting << ": " << refusal({setting});
}

TEST(Extremes, WhatTheTwoFluidModelCannotRepresentIsRefusedByKey) {
  for (const auto& [more, key] :
       {std::pair{Settings{"box.surface=lid", "box.lid_pressure=100"}, "box.surface: the air above the grains is open"},
        {Settings{"box.base=free_slip"}, "box.base: grains and air stick to a base that stands still"},
        {Settings{"box.base_speed=1"}, "box.base: grains and air stick to a base that stands still"},
        {Settings{"box.base_friction=0.3"}, "box.base_friction: grains and air stick to the base"},
        {Settings{"box.base_slip_length=1e-3"}, "box.base_slip_length: grains and air stick to the base"},
        {Settings{"box.base_slope=0.1"}, "box.base_slope: the base is a grid line"},
        {Settings{"box.right=wall", "box.end_walls=no_slip"}, "box.end_walls: grains and air slip along end walls"},
        {Settings{"box.left=wall", "box.right=wall"}, "box.right: grains that are poured must find a way out"},
        {Settings{"schedule.times=[0, 1]", "schedule.gap=[3e-3, 4e-3]"}, "schedule.times: the two-fluid model's box"},
        {Settings{"inflow.width=0.07"}, "inflow.position: the inlet, sqrt(12) inflow.width wide, leaves the top"},
        {Settings{"two_fluid.jet=free_fall", "two_fluid.jet_segregation=true"},
         "two_fluid.jet_segregation: no jet region is left where grains fall freely"},
        {Settings{"two_fluid.cells=reachable", "inflow.rate=0"},
         "two_fluid.cells: reachable cells are those that a jet pours grains into"},
        {Settings{"two_fluid.cells=reachable", "wall.mu_w=0"}, "two_fluid.cells: no steady slope is known"},
        {Settings{"integrator.method=steady"}, "integrator.method: the two-fluid model has no steady states"}}) {
    Settings settings = more;
    settings.emplace_back("model.name=two_fluid");
    EXPECT_NE(refusal(settings).find(key), std::string::npos) << more[0] << ": " << refusal(settings);
  }
  EXPECT_EQ(refusal({"model.name=two_fluid"}), "accepted");
}

}  // namespace
