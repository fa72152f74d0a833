#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"

/// The commands of the program on the examples.
namespace {
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::TemporaryFolder;

const std::filesystem::path examples = TALUS_SOURCE_DIR "/runs/examples";

std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(examples)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  return files;
}

Outcome talus(const std::vector<std::string>& arguments) { return outcome_of(TALUS_PROGRAM, arguments); }

bool says(const Outcome& outcome, const std::string& words) { return outcome.output.find(words) != std::string::npos; }

TEST(Cli, ChecksEveryExampleWithoutAWarning) {
  EXPECT_EQ(scenes().size(), 10U);
  for (const auto& file : scenes()) {
    const Outcome outcome = talus({"check", file.string()});
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_FALSE(says(outcome, "warning")) << outcome.output;
    EXPECT_TRUE(says(outcome, "steady     ")) << outcome.output;
  }
}

TEST(Cli, CheckTellsSizeAndTheExactSteadyState) {
  const Outcome q46 = talus({"check", (examples / "heap_q46.toml").string()});
  EXPECT_TRUE(says(q46, "300 columns x 32 layers = 9600 cells")) << q46.output;
  EXPECT_TRUE(says(q46, "29135 unknowns")) << q46.output;
  EXPECT_TRUE(says(q46, "a heap of slope 48.8126 degrees")) << q46.output;
  EXPECT_TRUE(says(talus({"check", (examples / "heap_q20.toml").string()}), "a heap of slope 44.0964 degrees"));
  EXPECT_TRUE(says(talus({"check", (examples / "heap_q60.toml").string()}), "a heap of slope 50.4152 degrees"));
  const Outcome bagnold = talus({"check", (examples / "heap_no_walls.toml").string()});
  EXPECT_TRUE(says(bagnold, "a layer over the base of slope 29.2000 degrees")) << bagnold.output;
  EXPECT_TRUE(says(bagnold, "thickest column 6.1 mm")) << bagnold.output;
}

TEST(Cli, ListsEveryExampleAndExplainsEverySection) {
  const Outcome list = talus({"list"});
  EXPECT_EQ(list.code, 0);
  for (const auto& file : scenes()) EXPECT_TRUE(says(list, file.filename().string() + ": ")) << list.output;
  const Outcome explained = talus({"explain"});
  for (const char* section : {"scene", "box", "grains", "rheology", "wall", "inflow", "model", "grid", "integrator",
                              "time", "output", "checkpoint"}) {
    EXPECT_TRUE(says(explained, "[" + std::string(section) + "]")) << section;
    EXPECT_EQ(talus({"explain", section}).code, 0);
  }
  const Outcome unknown = talus({"explain", "intergrator"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(says(unknown, "did you mean integrator?")) << unknown.output;
}

TEST(Cli, NamesItsVersionAndThoseOfItsLibraries) {
  const Outcome version = talus({"--version"});
  EXPECT_EQ(version.code, 0);
  for (const char* name : {"talus ", "SUNDIALS ", "SuiteSparse ", "netCDF ", "Eigen ", "toml++ "}) {
    const auto at = version.output.find(name);
    ASSERT_NE(at, std::string::npos) << version.output;
    EXPECT_NE(std::isdigit(static_cast<unsigned char>(version.output[at + std::string(name).size()])), 0)
        << version.output;
  }
}

TEST(Cli, MapsItsExitCodes) {
  EXPECT_EQ(talus({"--help"}).code, 0);
  EXPECT_EQ(talus({}).code, 2);
  EXPECT_EQ(talus({"fly"}).code, 2);
  EXPECT_EQ(talus({"run"}).code, 2);
  EXPECT_EQ(talus({"check", "no_such_scene.toml"}).code, 2);
  EXPECT_EQ(talus({"plot", "no_such_folder"}).code, 2);
}

TEST(Cli, ARunLeavesItsEffectiveSceneItsRecordsAndItsSummary) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const Outcome outcome = talus({"run", (examples / "chute_periodic.toml").string(), "--set", "time.end=0.1", "--set",
                                 "output.times=[0.013, 0.05]", "--set", "scene.name=short", "--out", out.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  for (const char* file : {"run.nc", "scene.toml", "run.log", "summary.json"})
    EXPECT_TRUE(std::filesystem::exists(out / file)) << file;

  const auto summary = nlohmann::json::parse(contents(out / "summary.json"));
  EXPECT_EQ(summary["status"], "finished");
  EXPECT_EQ(summary["exit_code"], 0);
  EXPECT_EQ(summary["scene"], "short");
  EXPECT_EQ(summary["final"]["time"], 0.1);
  ASSERT_EQ(summary["records"].size(), 2U);
  EXPECT_EQ(summary["records"][0]["time"], 0.013);
  EXPECT_EQ(summary["records"][1]["time"], 0.05);
  EXPECT_NEAR(summary["records"][1]["mass_stored"].get<double>(), 1500.0 * 0.003 * 0.02 * 0.012, 1e-12);
  EXPECT_GT(summary["statistics"]["steps"], 10);
  EXPECT_GT(summary["peak_memory_bytes"], 1000000);

  const Outcome again = talus({"run", (out / "scene.toml").string(), "--out", (folder / "again").string()});
  ASSERT_EQ(again.code, 0) << again.output;
  const auto repeated = nlohmann::json::parse(contents(folder / "again" / "summary.json"));
  EXPECT_EQ(repeated["final"], summary["final"]);
}
}  // namespace
