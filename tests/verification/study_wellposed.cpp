#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

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

/// The same noise on three grids: at I = 0.014 the classical law's grows the faster the finer the grid, the regularised law's decays on all; each
/// at the rate of its grid's own modes.
TEST(StudyWellposed, NoiseTellsTheLawsApartInTime) {
  for (const auto& [law, truth] : {std::pair{"classical", "blows up"}, {"partially_regularised", "decays"}}) {
    std::vector<std::string> words{"--parts", "time", "--levels", "3"};
    for (const std::string set : {"wall.mu_w=0", "box.tilt=22.05", "box.length=0.1", "model.initial_thickness=0.01",
                                  "grid.layers=12", "grid.columns=8", "grid.spacing=uniform", "rheology.p_0=0",
                                  "rheology.eta_max=1e8", "model.advection=central"})
      words.insert(words.end(), {"--set", set});
    words.insert(words.end(), {"--set", std::string("rheology.law=") + law});
    const auto found = study("examples/chute_periodic.toml", words);
    ASSERT_EQ(found.run.code, 0) << found.run.output;
    const auto& time = found.verdict.at("time");
    EXPECT_EQ(time.at("verdict"), truth) << found.run.output;
    for (const int grid : {0, 1}) {
      const auto& run = time.at("runs").at(grid);
      EXPECT_NEAR(run.at("rate_1_s").get<double>() / run.at("rate_of_modes_1_s").get<double>(), 1.0, 0.05)
          << law << ", grid " << grid;
    }
  }
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
}

}  // namespace
