#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "rheology/law.hpp"
#include "steady/uniform_flow.hpp"
#include "support/program.hpp"

/// `talus study converge` against flows whose limit is known.
namespace {

using namespace talus;
using Json = nlohmann::json;

constexpr double degree = 0.017453292519943295;

/// A Bagnold layer of 12 mm at 30 degrees, by KINSOL.
std::vector<std::string> bagnold(const std::filesystem::path& out, const std::vector<std::string>& more,
                                 const std::string& layers = "10", const std::string& times = "[]") {
  std::vector<std::string> words{"study", "converge", TALUS_SOURCE_DIR "/runs/examples/chute_periodic.toml", "--out",
                                 out.string()};
  for (const char* set : {"model.name=column", "integrator.method=steady", "wall.mu_w=0", "box.tilt=30",
                          "rheology.p_0=0", "rheology.eta_max=1e9", "grid.spacing=uniform"})
    words.insert(words.end(), {"--set", set});
  words.insert(words.end(), {"--set", "grid.layers=" + layers, "--set", "output.times=" + times});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

steady::UniformFlow exact_flow() {
  const auto law = rheology::partially_regularised(rheology::classical(0.4, 0.9, 1.3), 1.3, 1.9, 0.05178);
  const steady::Channel channel{
      .grains = rheology::grains(2500.0, 0.6, 0.00073), .law = law, .gap = 0.003, .mu_w = 0.0, .gravity = 9.81};
  return *steady::UniformFlow::at(channel, 30.0 * degree, 0.012);
}

Json verdict_in(const std::filesystem::path& folder) { return Json::parse(support::contents(folder / "verdict.json")); }

TEST(StudyConverge, FindsOrderAndLimitOfBagnoldsFlow) {
  const support::TemporaryFolder folder;
  const auto out = folder / "study";
  const auto run = support::outcome_of(TALUS_PROGRAM, bagnold(out, {"--levels", "4", "--jobs", "1"}));
  ASSERT_EQ(run.code, 0) << run.output;
  const auto verdict = verdict_in(out);
  const auto& flow = verdict["numbers"]["flow_per_width"];
  ASSERT_EQ(flow["orders"].size(), 2U);
  for (const auto& order : flow["orders"]) EXPECT_NEAR(order.get<double>(), 2.0, 0.05);
  const double exact = exact_flow().flux() / (1500.0 * 0.003);
  EXPECT_LT(std::abs(flow["extrapolated"].get<double>() - exact), 1e-6 * exact);
  EXPECT_LT(std::abs(flow["values"][3].get<double>() - exact), flow["uncertainty"].get<double>());
  const auto& surface = verdict["numbers"]["surface_speed"];
  EXPECT_NEAR(surface["orders"][1].get<double>(), 1.6, 0.15) << "u ~ depth^1.5 under the surface";
  EXPECT_LT(std::abs(surface["values"][3].get<double>() - exact_flow().surface_speed()),
            surface["uncertainty"].get<double>());
  EXPECT_NEAR(verdict["fields"]["u"]["orders"][1].get<double>(), 2.0, 0.1);
  EXPECT_EQ(verdict["numbers"]["gap"]["tendency"], "settled");
  EXPECT_NE(run.output.find("flow_per_width"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(out / "study.nc"));
  EXPECT_TRUE(std::filesystem::exists(out / "study.png")) << run.output;

  const auto again = support::outcome_of(TALUS_PROGRAM, bagnold(out, {"--levels", "5", "--jobs", "1"}));
  ASSERT_EQ(again.code, 0) << again.output;
  EXPECT_NE(again.output.find("5 finished (4 of them before)"), std::string::npos) << again.output;
  EXPECT_EQ(verdict_in(out)["numbers"]["flow_per_width"]["orders"].size(), 3U);
}

/// Records of a steady state that is the end's are no further numbers; that of a box that has moved since is one.
TEST(StudyConverge, ASteadyStateIsToldOnce) {
  const support::TemporaryFolder folder;
  const auto numbers_of = [&](const std::string& name, const std::vector<std::string>& more) {
    auto words = bagnold(folder / name, {"--levels", "2"}, "10", "[0.5, 1.5]");
    words.insert(words.end(), more.begin(), more.end());
    const auto run = support::outcome_of(TALUS_PROGRAM, words);
    EXPECT_EQ(run.code, 0) << run.output;
    return verdict_in(folder / name)["numbers"];
  };
  const auto still = numbers_of("still", {});
  EXPECT_TRUE(still.contains("flow_per_width"));
  EXPECT_FALSE(still.contains("flow_per_width@0.5"));
  EXPECT_FALSE(still.contains("flow_per_width@1.5"));
  const auto turned =
      numbers_of("turned", {"--set", "schedule.times=[0.0, 1.0]", "--set", "schedule.tilt=[30.0, 28.0]"});
  EXPECT_FALSE(turned.contains("flow_per_width@1.5"));
  ASSERT_TRUE(turned.contains("flow_per_width@0.5"));
  EXPECT_GT(turned["flow_per_width@0.5"]["values"][0], turned["flow_per_width"]["values"][0]);
}

TEST(StudyConverge, TwoLevelsGiveNoOrder) {
  const support::TemporaryFolder folder;
  const auto run = support::outcome_of(TALUS_PROGRAM, bagnold(folder / "study", {"--levels", "2"}));
  ASSERT_EQ(run.code, 0) << run.output;
  const auto verdict = verdict_in(folder / "study");
  EXPECT_EQ(verdict["verdict"], "cannot tell");
  EXPECT_TRUE(verdict["numbers"]["flow_per_width"]["orders"].empty());
  EXPECT_TRUE(verdict["numbers"]["flow_per_width"]["uncertainty"].is_null());
}

/// Levels finer than a scene may have are refused before any is run.
TEST(StudyConverge, WhatCannotRunIsTold) {
  const support::TemporaryFolder folder;
  const auto refused = support::outcome_of(TALUS_PROGRAM, bagnold(folder / "a", {"--levels", "3"}, "1000"));
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.output.find("member 2 (grid.layers = 4000)"), std::string::npos) << refused.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
  const auto direction = support::outcome_of(TALUS_PROGRAM, bagnold(folder / "b", {"--in", "x"}));
  EXPECT_EQ(direction.code, 2);
  EXPECT_NE(direction.output.find("the column model has no cells along x; expected some of z, t"), std::string::npos)
      << direction.output;
}

/// Tolerances alone: the flow of a run in time nears that of the finest tolerance.
TEST(StudyConverge, RefinesTolerances) {
  const support::TemporaryFolder folder;
  const auto run = support::outcome_of(TALUS_PROGRAM, {"study",
                                                       "converge",
                                                       TALUS_SOURCE_DIR "/runs/examples/chute_periodic.toml",
                                                       "--out",
                                                       (folder / "t").string(),
                                                       "--in",
                                                       "t",
                                                       "--levels",
                                                       "4",
                                                       "--set",
                                                       "model.name=column",
                                                       "--set",
                                                       "integrator.rtol=1e-2",
                                                       "--set",
                                                       "integrator.atol_velocity=1e-3",
                                                       "--set",
                                                       "grid.layers=16",
                                                       "--set",
                                                       "time.end=0.1",
                                                       "--set",
                                                       "output.times=[]"});
  ASSERT_EQ(run.code, 0) << run.output;
  const auto flow = verdict_in(folder / "t")["numbers"]["mass_flow"]["values"];
  ASSERT_EQ(flow.size(), 4U);
  EXPECT_NE(flow[0], flow[3]);
  EXPECT_LT(std::abs(flow[3].get<double>() - flow[2].get<double>()),
            std::abs(flow[3].get<double>() - flow[0].get<double>()));
}

}  // namespace
