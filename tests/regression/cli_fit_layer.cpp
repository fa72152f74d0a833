#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "support/nc_reader.hpp"
#include "support/program.hpp"

/// The second stage of `talus fit`, by runs of a small pour: data of known parameters, a fit killed, a run file as data, bad input.
namespace {
using namespace std::chrono_literals;
using nlohmann::json;
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::Program;
using talus::support::TemporaryFolder;

const std::string scene = TALUS_SOURCE_DIR "/runs/studies/fit/pour_heap.toml";
const std::vector<std::string> small{"grid.columns=20", "grid.layers=6", "inflow.stop=5", "time.end=8"};
const std::string truth_of_base = "0.3";

std::string in_quotes(const std::vector<std::string>& words) {
  std::string out;
  for (const auto& word : words) out += (out.empty() ? "\"" : ", \"") + word + "\"";
  return out;
}

/// Of the true run: what a laboratory would measure, with normal errors.
class Pour {
 public:
  Pour() {
    std::vector<std::string> words{"run", scene, "--out", (folder_ / "truth").string()};
    for (const auto& one : small) words.insert(words.end(), {"--set", one});
    const std::vector<std::string> own{"box.base_friction=" + truth_of_base, "output.times=[3,5,7]",
                                       "output.fields=false"};
    for (const auto& one : own) words.insert(words.end(), {"--set", one});
    const auto outcome = outcome_of(TALUS_PROGRAM, words);
    if (outcome.code != 0) throw std::runtime_error(outcome.output);
    talus::support::NcReader run(file());
    times = run.values("series_time"), x = run.values("x");
    heights = run.values("height_series"), mass = run.values("mass_outflow_right");
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "truth" / "run.nc"; }
  std::vector<double> times, x, heights, mass;

 private:
  TemporaryFolder folder_;
};

const Pour& pour() {
  static const Pour made;
  return made;
}

class FitLayerCommand : public testing::Test {
 protected:
  std::vector<std::string> command(const std::string& rest, const std::string& out = "out",
                                   const std::string& unknown = base_friction, const std::string& sets = "") {
    std::ofstream(folder_ / "fit.toml") << "[fit]\nname = \"f\"\nmaterial = \"" << scene << "\"\n[stage_2]\nscene = \""
                                        << scene << "\"\nset = [" << in_quotes(small) << sets << "]\n"
                                        << unknown << rest;
    return {"fit", (folder_ / "fit.toml").string(), "--out", (folder_ / out).string()};
  }
  void data(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  void noisy_data(unsigned seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    std::ofstream shapes(folder_ / "h.csv"), masses(folder_ / "m.csv");
    shapes << "time_s,x_m,height_m,height_error_m\n", masses << "time_s,mass_kg,mass_error_kg\n";
    const auto& p = pour();
    for (std::size_t k = 0; k < p.times.size(); ++k) {
      if (p.times[k] == 3.0 || p.times[k] == 5.0)
        for (std::size_t i = 10; i + 1 < p.x.size(); ++i) {  // between the middles of columns
          const double* h = &p.heights[k * p.x.size() + i];
          shapes << p.times[k] << "," << 0.5 * (p.x[i] + p.x[i + 1]) << ","
                 << 0.5 * (h[0] + h[1]) + 5e-4 * normal(engine) << ",5e-4\n";
        }
      if (p.times[k] >= 2.0) masses << p.times[k] << "," << p.mass[k] + 3e-4 * normal(engine) << ",3e-4\n";
    }
  }
  void refused(const std::string& rest, const std::vector<std::string>& words,
               const std::string& unknown = base_friction, const std::string& sets = "") {
    const Outcome outcome = outcome_of(TALUS_PROGRAM, command(rest, "out", unknown, sets));
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    for (const auto& each : words)
      EXPECT_NE(outcome.output.find(each), std::string::npos) << each << "\n" << outcome.output;
  }
  [[nodiscard]] json answer(const std::string& out = "out") const {
    return json::parse(contents(folder_ / out / "fit.json"));
  }

  static inline const std::string base_friction =
      "[[unknown]]\nparameter = \"box.base_friction\"\nlow = 0.15\nhigh = 0.6\nstart = 0.36\n";
  static inline const std::string mu_w = "[[unknown]]\nparameter = \"mu_w\"\nlow = 0.2\nhigh = 0.6\nstart = 0.40\n";
  static inline const std::string both =
      "[[shape]]\nfile = \"h.csv\"\n[[series]]\nfile = \"m.csv\"\nquantity = \"mass_outflow_right\"\n";
  TemporaryFolder folder_;
};

TEST_F(FitLayerCommand, NoisyShapesAndOutflowGiveTheParametersBack) {
  noisy_data(5);
  const Outcome outcome = outcome_of(TALUS_PROGRAM, command(both, "out", mu_w + base_friction));
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("stage 2: 3 of at most 60 runs; chi2"), std::string::npos) << outcome.output;
  const json found = answer();
  const double truth[] = {0.3727, 0.3};
  for (std::size_t i = 0; i < 2; ++i) {
    const double value = found["unknown"]["value"]["values"][i], error = found["unknown"]["error"]["values"][i];
    EXPECT_NEAR(value, truth[i], 2.0 * error) << found["unknown"]["name"]["values"][i];
    EXPECT_LT(error, 0.1 * value);
    EXPECT_NEAR(found["covariance"][i][i].get<double>(), error * error, 1e-9 * error * error);
  }
  EXPECT_GT(found["chance_of_more"].get<double>(), 0.001);
  EXPECT_EQ(found["stage_2"]["converged"], true);
  EXPECT_EQ(found["stage_2"]["seen_by_layer_only"], json({"mu_w", "box.base_friction"}));
  EXPECT_EQ(found["data"]["time_s"]["values"].size(), 18U + 7U);
  const Outcome page = outcome_of(TALUS_PROGRAM, {"plot", (folder_ / "out").string()});
  EXPECT_EQ(page.code, 0) << page.output;
  EXPECT_GT(std::filesystem::file_size(folder_ / "out" / "fit.png"), 20000U);
}

TEST_F(FitLayerCommand, AFitThatWasKilledGoesOnToTheSameAnswer) {
  noisy_data(6);
  ASSERT_EQ(outcome_of(TALUS_PROGRAM, command(both, "whole")).code, 0);
  for (const int signal : {SIGKILL, SIGTERM}) {
    const std::string out = signal == SIGKILL ? "killed" : "stopped";
    // There the fit listens: it waits for runs.
    const auto second = folder_ / out / "stage_2" / "batch_002" / "members" / "0000" / "console.log";
    Program program(TALUS_PROGRAM, command(both, out));
    while (program.running() && !std::filesystem::exists(second)) std::this_thread::sleep_for(5ms);
    ASSERT_TRUE(program.running()) << program.output();
    program.send(signal);
    EXPECT_EQ(program.wait(), signal == SIGKILL ? 1000 + SIGKILL : 75) << program.output();
    const auto run = folder_ / out / "stage_2" / "batch_001" / "members" / "0000" / "run.nc";
    const auto made = std::filesystem::last_write_time(run);
    const Outcome outcome = outcome_of(TALUS_PROGRAM, command(both, out));
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(std::filesystem::last_write_time(run), made);
    EXPECT_EQ(answer(out), answer("whole"));
  }
}

TEST_F(FitLayerCommand, ARunFileIsData) {
  const std::string file = "file = \"" + pour().file().string() + "\"\n";
  const Outcome outcome =
      outcome_of(TALUS_PROGRAM, command("[[shape]]\n" + file + "error = 5e-4\ntimes = [3, 5]\n[[series]]\n" + file +
                                        "quantity = \"mass_stored\"\nerror = 3e-4\n"));
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_NEAR(answer()["unknown"]["value"]["values"][0].get<double>(), 0.3, 1e-3);
  EXPECT_LT(answer()["chi2"].get<double>(), 0.1);
  refused("[[shape]]\n" + file, {"shape.error: missing; a run file states no errors", "shape.times: missing"});
  refused("[[shape]]\n" + file + "error = 1e-3\ntimes = [3.5]\n",
          {"fit.toml:15:1: shape.times: nothing is recorded at 3.5 s"});
}

TEST_F(FitLayerCommand, ARunThatTheSceneRefusesIsSaidAndNotAnError) {
  noisy_data(7);
  // The first difference goes to where no run is: the jet would miss the base.
  const std::string position =
      "[[unknown]]\nparameter = \"inflow.position\"\nlow = 0.05\nhigh = 0.12\nstart = 0.1125\n";
  const Outcome outcome = outcome_of(TALUS_PROGRAM, command(both, "out", position, ", \"box.base_friction=0.3\""));
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  const json found = answer();
  ASSERT_FALSE(found["stage_2"]["failures"].empty()) << outcome.output;
  const std::string first = found["stage_2"]["failures"][0];
  EXPECT_NE(first.find("run 2, inflow.position = 0.11475: refused: --set: inflow.position: the jet meets the base at"),
            std::string::npos)
      << first;
  EXPECT_NE(outcome.output.find("failed, and counted as far from the data"), std::string::npos) << outcome.output;
  const double error = found["unknown"]["error"]["values"][0];
  EXPECT_NEAR(found["unknown"]["value"]["values"][0].get<double>(), 0.08, 2.0 * error);
}

TEST_F(FitLayerCommand, BadLayerDataAreRefusedWithTheirPlace) {
  const std::string shape = "[[shape]]\nfile = \"h.csv\"\n", header = "time_s,x_m,height_m,height_error_m\n";
  data("h.csv", "");
  refused(shape, {"h.csv: has no header"});
  data("h.csv", header);
  refused(shape, {"fit.toml:13:1: shape.file: h.csv: expected at least 1 row of data, found 0"});
  data("h.csv", "time_s,x_m,height_mm,height_error_m\n1,0.1,3,0.1\n");
  refused(shape, {"h.csv:1: height_m: missing column; expected a number at least 0 [m]", "height_mm: unknown column"});
  data("h.csv", header + "9,0.1,0.01,0.001\n1,0.3,0.01,0.001\n");
  refused(shape, {"h.csv:2: time_s: expected a number at least 0 and at most 8 [s] (time.end of ", "found '9'",
                  "h.csv:3: x_m: expected a number at least 0 and at most 0.25 [m] (box.length of ", "found '0.3'"});
  data("h.csv", header + "1,0.1,0.01,0.001\n");
  refused(shape + "error = 0.001\n", {"shape.error: is for run files"});
  data("m.csv", "time_s,mass_g,mass_error_g\n1,2,1\n");
  refused("[[series]]\nfile = \"m.csv\"\nquantity = \"mass_stored\"\n",
          {"m.csv:1: mass_kg: missing column", "mass_g: unknown column"});
  data("m.csv", "time_s,mass_kg,mass_error_kg\n1,2,1\n");
  refused("[[series]]\nfile = \"m.csv\"\nquantity = \"outflow_rate_right\"\n", {"m.csv:1: rate_kg_s: missing column"});
  refused("[[series]]\nfile = \"m.csv\"\nquantity = \"mass\"\n", {"series.quantity", "mass_stored"});
  refused("", {"stage_2: no data for it; expected [[shape]] or [[series]]"});
}

TEST_F(FitLayerCommand, BadSecondStagesAreRefusedWithTheirKey) {
  data("h.csv", "time_s,x_m,height_m,height_error_m\n1,0.1,0.01,0.001\n");
  const std::string shape = "[[shape]]\nfile = \"h.csv\"\n";
  const auto unknown = [](const std::string& lines) { return "[[unknown]]\nparameter = " + lines; };
  refused(shape, {"box.base_fraction: is no number of a scene (did you mean box.base_friction?)"},
          unknown("\"box.base_fraction\"\nlow = 0.1\nhigh = 0.2\n"));
  refused(shape, {"grid.columns: is no number of a scene"}, unknown("\"grid.columns\"\nlow = 10.0\nhigh = 20.0\n"));
  refused(shape, {"unknown.low: box.base_friction: the start 0.4, the scene's, is not between 0.1 and 0.2 [1]"},
          unknown("\"box.base_friction\"\nlow = 0.1\nhigh = 0.2\n"));
  refused(shape, {"box.base_friction: is unknown twice"}, base_friction + base_friction);
  refused(shape, {"wall.mu_w: is unknown twice"}, mu_w + unknown("\"wall.mu_w\"\nlow = 0.1\nhigh = 0.6\n"));
  refused(shape, {"stage_2.scene: expected the material of fit.material; mu_d is 0.8 there and 0.9 here"},
          base_friction, ", \"rheology.mu_d=0.8\"");
  std::ofstream(folder_ / "alone.toml") << "[fit]\nname = \"f\"\nmaterial = \"" << scene << "\"\n"
                                        << base_friction << shape;
  const Outcome alone = outcome_of(TALUS_PROGRAM, {"fit", (folder_ / "alone.toml").string()});
  EXPECT_EQ(alone.code, 2);
  EXPECT_NE(alone.output.find("unknown.parameter: is for the layer model; expected [stage_2]"), std::string::npos)
      << alone.output;
}
}  // namespace
