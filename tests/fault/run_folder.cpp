#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "support/program.hpp"

/// What can go wrong with the output folder and during a run, through the program.
namespace {
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::Program;
using talus::support::TemporaryFolder;

const std::string chute = TALUS_SOURCE_DIR "/runs/examples/chute_periodic.toml";

Outcome run_into(const std::filesystem::path& folder, std::vector<std::string> more = {}, rlim_t file_size_limit = 0) {
  std::vector<std::string> arguments{"run",   chute,          "--set", "time.end=0.01", "--set", "output.times=[]",
                                     "--out", folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return outcome_of(TALUS_PROGRAM, arguments, file_size_limit);
}

nlohmann::json summary_in(const std::filesystem::path& folder) {
  return nlohmann::json::parse(contents(folder / "summary.json"));
}

bool says(const Outcome& outcome, const std::string& words) { return outcome.output.find(words) != std::string::npos; }

TEST(RunFolder, ThatCannotBeMadeIsRefused) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  const Outcome outcome = run_into(folder / "file" / "out");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(says(outcome, "talus: output folder " + (folder / "file" / "out").string() + ": cannot be created: "))
      << outcome.output;
}

TEST(RunFolder, ThatHoldsARunIsRefusedUnlessForced) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_into(folder / "out").code, 0);
  const std::string before = contents(folder / "out" / "summary.json");

  const Outcome again = run_into(folder / "out");
  EXPECT_EQ(again.code, 3);
  EXPECT_TRUE(says(again, "holds a run already (run.nc); --force replaces it, --out names another folder"))
      << again.output;
  EXPECT_EQ(contents(folder / "out" / "summary.json"), before);

  EXPECT_EQ(run_into(folder / "out", {"--force", "--set", "scene.name=second"}).code, 0);
  EXPECT_EQ(summary_in(folder / "out")["scene"], "second");
}

TEST(RunFolder, AnEarlierRunIsNotTouchedByABadScene) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_into(folder / "out").code, 0);
  EXPECT_EQ(run_into(folder / "out", {"--force", "--set", "box.gap=0"}).code, 2);
  EXPECT_EQ(summary_in(folder / "out")["status"], "finished");
}

TEST(RunFolder, FullDiskEndsTheRunWithASummary) {
  const TemporaryFolder folder;
  constexpr rlim_t room_for_some_records = 17 * 1024 * 1024;  // the writer wants 16 MiB to stay free
  const Outcome outcome = run_into(
      folder / "out", {"--set", "output.series_interval=1e-7", "--set", "output.fields=false"}, room_for_some_records);
  EXPECT_EQ(outcome.code, 5) << outcome.output;
  const auto summary = summary_in(folder / "out");
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_EQ(summary["exit_code"], 5);
  EXPECT_NE(summary["reason"].get<std::string>().find("disk full"), std::string::npos) << summary["reason"];
}

TEST(RunFolder, SolverThatGivesUpNamesTheWorstRowsAndLeavesASummary) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_into(folder / "out", {"--set", "integrator.rtol=1e-15", "--set", "integrator.atol_velocity=1e-18", "--set",
                                "integrator.atol_height=1e-20"});
  EXPECT_EQ(outcome.code, 6);
  EXPECT_TRUE(says(outcome, "u at face 3, layer 0 of 32 (x = 0.015 m)")) << outcome.output;
  const auto summary = summary_in(folder / "out");
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_EQ(summary["exit_code"], 6);
  EXPECT_NE(summary["reason"].get<std::string>().find("IDA_ERR_FAIL"), std::string::npos) << summary["reason"];
  EXPECT_NE(summary["integrator"].get<std::string>().find("SUNDIALS IDA"), std::string::npos);
}

/// Starts a run that would take minutes and waits until it integrates.
class LongRun : public testing::Test {
 protected:
  void SetUp() override {
    const auto log = folder_ / "out" / "run.log";
    for (int i = 0; i < 3000 && contents(log).find("steps") == std::string::npos && program_.running(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ASSERT_TRUE(program_.running()) << program_.output();
  }

  TemporaryFolder folder_;
  Program program_{TALUS_PROGRAM,
                   {"run", chute, "--set", "time.end=100", "--set", "integrator.max_step=1e-5", "--set",
                    "output.series_interval=1e-4", "--out", (folder_ / "out").string()}};
};

TEST_F(LongRun, LocksItsFolder) {
  const Outcome second = run_into(folder_ / "out", {"--force"});
  EXPECT_EQ(second.code, 7);
  EXPECT_TRUE(says(second, "another run is writing to it")) << second.output;
}

TEST_F(LongRun, StopsCleanlyOnASignal) {
  program_.send(SIGTERM);
  EXPECT_EQ(program_.wait(), 128 + SIGTERM);
  const auto summary = summary_in(folder_ / "out");
  EXPECT_EQ(summary["status"], "stopped");
  EXPECT_EQ(summary["exit_code"], 128 + SIGTERM);
  EXPECT_EQ(summary["reason"], "stopped by signal 15");
  EXPECT_GT(summary["simulated_seconds"].get<double>(), 0.0);
  EXPECT_LT(summary["simulated_seconds"].get<double>(), 100.0);
}
}  // namespace
