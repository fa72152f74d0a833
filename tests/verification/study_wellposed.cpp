#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "support/program.hpp"

/// `talus study wellposed` against laws whose truth is known.
namespace {

using namespace talus;
using Json = nlohmann::json;

struct Study {
  support::Outcome run;
  Json verdict;
};

Study study(const std::string& scene, std::vector<std::string> words) {
  const support::TemporaryFolder folder;
  words.insert(words.begin(),
               {"study", "wellposed", TALUS_SOURCE_DIR "/runs/" + scene, "--out", (folder / "s").string()});
  Study result{support::outcome_of(TALUS_PROGRAM, words), {}};
  const auto text = support::contents(folder / "s/verdict.json");
  if (!text.empty()) result.verdict = Json::parse(text);
  EXPECT_TRUE(std::filesystem::exists(folder / "s/study.nc")) << result.run.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "s/study.png")) << result.run.output;
  return result;
}

/// Of the symbol at each inertial number.
std::vector<std::string> verdicts(const Study& study) {
  std::vector<std::string> words;
  for (const auto& point : study.verdict.at("symbol").at("points")) words.push_back(point.at("verdict"));
  return words;
}

TEST(StudyWellposed, TheClassicalLawIsIllPosedAtLowAndHighInertialNumbers) {
  const auto found = study("examples/heap_q46.toml", {"--parts", "symbol", "--cells", "128", "--I", "0.001,0.5,20",
                                                      "--set", "rheology.law=classical"});
  ASSERT_EQ(found.run.code, 0) << found.run.output;
  EXPECT_EQ(verdicts(found), (std::vector<std::string>{"ill-posed", "well-posed", "ill-posed"}));
  EXPECT_EQ(found.verdict["verdict"], "blows up");
  EXPECT_NEAR(found.verdict["rate_exponent"].get<double>(), 2.0, 0.1);
  for (const int i : {0, 2}) {
    const auto& point = found.verdict["symbol"]["points"][i];
    EXPECT_NEAR(point["rate_exponent"].get<double>(), 2.0, 0.1) << "growth as k^2";
    EXPECT_TRUE(point["grows_by_linear_theory"].get<bool>());
  }
  const auto& low = found.verdict["symbol"]["points"][0];
  EXPECT_GT(low["growth_over_shear"].back().get<double>(), 0.0);
  EXPECT_LT(low["growth_over_shear_with_averaged_viscosity"][1].get<double>(), 0.0) << "averages hide it on 32 cells";
}

/// Between C = 0 and q = 1 (I 1.03 to 1.75) the paper's criterion and linear theory part: no wave of any grid grows.
TEST(StudyWellposed, TheRegularisedLawIsWellPosedUpToTheLossOfEllipticity) {
  const auto found =
      study("examples/heap_q46.toml", {"--parts", "symbol", "--cells", "128", "--I", "0.001,0.5,1.2,1.6,2.5,20"});
  ASSERT_EQ(found.run.code, 0) << found.run.output;
  EXPECT_EQ(verdicts(found), (std::vector<std::string>{"well-posed", "well-posed", "well-posed", "well-posed",
                                                       "ill-posed", "ill-posed"}));
  EXPECT_EQ(found.verdict["verdict"], "convergent") << "at the inertial numbers of its own steady flow";
  for (const int i : {2, 3}) {
    const auto& point = found.verdict["symbol"]["points"][i];
    EXPECT_GT(point["C"].get<double>(), 0.0);
    EXPECT_LT(point["q"].get<double>(), 1.0);
  }
  EXPECT_GT(found.verdict["symbol"]["points"][4]["q"].get<double>(), 1.0);
}

/// A Bagnold layer under the classical law at I = 0.038: unstable, and the faster the shorter the wave; under the regularised law stable.
TEST(StudyWellposed, ModesOfAUniformLayerTellTheLawsApart) {
  const std::vector<std::string> flow{"--parts", "modes",
                                      "--waves", "12",
                                      "--set",   "wall.mu_w=0",
                                      "--set",   "box.tilt=22.5",
                                      "--set",   "model.initial_thickness=0.01",
                                      "--set",   "grid.layers=48",
                                      "--set",   "grid.columns=48",
                                      "--set",   "grid.spacing=uniform",
                                      "--set",   "rheology.p_0=0",
                                      "--set",   "rheology.eta_max=1e8",
                                      "--set",   "model.advection=central",
                                      "--set",   "box.length=0.01"};
  const auto partial = study("examples/chute_periodic.toml", flow);
  auto words = flow;
  words.insert(words.end(), {"--set", "rheology.law=classical"});
  const auto classical = study("examples/chute_periodic.toml", words);
  ASSERT_EQ(partial.run.code, 0) << partial.run.output;
  ASSERT_EQ(classical.run.code, 0) << classical.run.output;
  const auto fastest = [](const Study& s) {
    double growth = -1e300;
    for (const auto& wave : s.verdict.at("modes").at("waves"))
      growth = std::max(growth, wave.at("growth_1_s").get<double>());
    return growth;
  };
  EXPECT_LT(fastest(partial), 10.0) << "roll waves at most";
  EXPECT_GT(fastest(classical),
            20.0);  // 31 here; the band of growing waves is narrow, and more layers find faster ones
  for (const auto* found : {&partial, &classical}) {
    EXPECT_LT(found->verdict["modes"]["steady_residual"].get<double>(), 1e-6);
    for (const auto& wave : found->verdict["modes"]["waves"]) EXPECT_LT(wave["residual"].get<double>(), 1e-7);
  }
}

/// Bagnold's flow of 10 mm at an angle [degree], on `columns` by `layers` cells and their refinements.
Study disturbed(const support::TemporaryFolder& folder, const std::string& law, const std::string& angle,
                const std::string& levels, const std::string& columns, const std::string& layers) {
  std::vector<std::string> words{"study",
                                 "wellposed",
                                 TALUS_SOURCE_DIR "/runs/examples/chute_periodic.toml",
                                 "--out",
                                 (folder / law).string(),
                                 "--parts",
                                 "time",
                                 "--jobs",
                                 "2",
                                 "--levels",
                                 levels,
                                 "--single",
                                 "1"};
  for (const std::string& set :
       {std::string("wall.mu_w=0"), std::string("box.length=0.1"), std::string("model.initial_thickness=0.01"),
        std::string("grid.spacing=uniform"), std::string("rheology.p_0=0"), std::string("rheology.eta_max=1e8"),
        std::string("model.advection=central"), "rheology.law=" + law, "box.tilt=" + angle, "grid.columns=" + columns,
        "grid.layers=" + layers})
    words.insert(words.end(), {"--set", set});
  Study result{support::outcome_of(TALUS_PROGRAM, words), {}};
  const auto text = support::contents(folder / law / "verdict.json");
  if (!text.empty()) result.verdict = Json::parse(text);
  return result;
}

const Json& disturbance(const Study& study, const std::string& name) {
  for (const auto& each : study.verdict.at("time").at("disturbances"))
    if (each.at("disturbance") == name) return each;
  throw std::runtime_error("no disturbance " + name);
}

/// The same disturbances on three grids: at I = 0.014 the classical law's grow the faster the finer the grid, the regularised law's decay on all; noise
/// grows at the rate of its grid's own modes.
TEST(StudyWellposed, DisturbancesTellTheLawsApartInTime) {
  const support::TemporaryFolder folder;
  for (const auto& [law, verdict, of_noise] :
       {std::tuple{"classical", "blows up", "blows up"}, std::tuple{"partially_regularised", "convergent", "decays"}}) {
    const auto found = disturbed(folder, law, "22.05", "3", "8", "12");
    ASSERT_EQ(found.run.code, 0) << found.run.output;
    EXPECT_EQ(found.verdict.at("verdict"), verdict) << found.run.output;
    EXPECT_EQ(found.verdict.at("by"), "disturbances in time on 3 grids");
    EXPECT_EQ(disturbance(found, "grid noise").at("verdict"), of_noise);
    for (const auto& name : {"noise", "grid noise"})
      for (const int grid : {0, 1}) {
        const auto& run = disturbance(found, name).at("runs").at(grid);
        EXPECT_NEAR(run.at("rate_1_s").get<double>() / run.at("rate_of_modes_1_s").get<double>(), 1.0, 0.05)
            << law << ", " << name << ", grid " << grid;
        EXPECT_TRUE(run.at("broke_down").is_null());
        EXPECT_GT(run.at("points"), 20);
      }
    // The coarsest grid is its own: its noise is the grid's.
    EXPECT_EQ(disturbance(found, "noise").at("runs").at(0), disturbance(found, "grid noise").at("runs").at(0));
    EXPECT_EQ(disturbance(found, "wave 1").at("runs").at(1).at("last_wave"), 1);
    EXPECT_EQ(disturbance(found, "grid noise").at("runs").at(1).at("last_wave"), 7);
    const auto& theory = found.verdict.at("time").at("ill_posed_in_theory");
    EXPECT_EQ(theory.is_null(), std::string(law) != "classical");
    EXPECT_TRUE(std::filesystem::exists(folder / law / "study.nc"));
    EXPECT_TRUE(std::filesystem::exists(folder / law / "study.png")) << found.run.output;
  }
}

/// Two grids cannot tell, and name the next; with a third the first two are not run again.
TEST(StudyWellposed, MoreGridsGoOnFromThoseThatWereRun) {
  const support::TemporaryFolder folder;
  const auto two = disturbed(folder, "partially_regularised", "22.05", "2", "5", "4");
  ASSERT_EQ(two.run.code, 0) << two.run.output;
  EXPECT_EQ(two.verdict.at("verdict"), "cannot tell");
  EXPECT_EQ(two.verdict.at("grid_that_may_tell"), "20x16");
  const auto three = disturbed(folder, "partially_regularised", "22.05", "3", "5", "4");
  ASSERT_EQ(three.run.code, 0) << three.run.output;
  EXPECT_NE(three.run.output.find("9 members: 9 finished (6 of them before)"), std::string::npos) << three.run.output;
}

/// Grids that show no growth where linear theory knows of some cannot tell: the symbol names the one that would.
TEST(StudyWellposed, GridsThatHideGrowthCannotTell) {
  const support::TemporaryFolder folder;
  const auto found = disturbed(folder, "classical", "22.45", "3", "5", "4");
  ASSERT_EQ(found.run.code, 0) << found.run.output;
  EXPECT_EQ(disturbance(found, "grid noise").at("verdict"), "decays") << found.run.output;
  EXPECT_EQ(found.verdict.at("verdict"), "cannot tell");
  EXPECT_EQ(found.verdict.at("time").at("ill_posed_in_theory").at("share_of_thickness"), 1.0);
  EXPECT_EQ(found.verdict.at("time").at("ill_posed_in_theory").at("seen_from_cells"), 64);
  EXPECT_EQ(found.verdict.at("grid_that_may_tell"), "80x64");
}

/// Tolerances below rounding break every run down: where and when is told, the study ends as usual.
TEST(StudyWellposed, ARunThatBreaksDownIsAResult) {
  const auto found = study("examples/chute_periodic.toml",
                           {"--parts", "time", "--levels", "2", "--set", "rheology.law=classical", "--set",
                            "box.tilt=22.05", "--set", "grid.columns=8", "--set", "grid.layers=12", "--set",
                            "integrator.rtol=1e-12", "--set", "integrator.atol_velocity=1e-15"});
  ASSERT_EQ(found.run.code, 0) << found.run.output;
  EXPECT_EQ(found.verdict.at("verdict"), "cannot tell");
  const auto run = disturbance(found, "noise").at("runs").at(0);
  EXPECT_NE(run.at("broke_down").get<std::string>().find("IDA gave up"), std::string::npos);
  EXPECT_TRUE(run.at("rate_1_s").is_null());
  EXPECT_EQ(run.at("reached_s"), 0.0);
  EXPECT_GE(run.at("strongest_wave_at_end"), 1);
  EXPECT_GT(run.at("largest_at_end_m").at("z"), 0.0);
}

TEST(StudyWellposed, BadInputIsNamed) {
  const auto refuse = [](std::vector<std::string> words) {
    const support::TemporaryFolder folder;
    words.insert(words.begin(), {"study", "wellposed", TALUS_SOURCE_DIR "/runs/examples/chute_periodic.toml", "--out",
                                 (folder / "s").string()});
    const auto run = support::outcome_of(TALUS_PROGRAM, words);
    EXPECT_EQ(run.code, 2) << run.output;
    return run.output;
  };
  EXPECT_NE(refuse({"--cells", "100"}).find("--cells: expected a power of 2, at least 16, found 100"),
            std::string::npos);
  EXPECT_NE(refuse({"--I", "0,1"}).find("--I: expected inertial numbers above 0"), std::string::npos);
  EXPECT_NE(refuse({"--parts", "space"}).find("--parts"), std::string::npos);
  EXPECT_NE(
      refuse({"--parts", "time", "--single", "2"}).find("--single: expected whole waves over the box from 1 to 1"),
      std::string::npos);
  EXPECT_NE(refuse({"--set", "disturbance.speed=1e-4", "--set", "disturbance.first_wave=2"})
                .find("disturbance.first_wave: the columns carry waves of more than two of them; expected at most 1"),
            std::string::npos);
}

}  // namespace
