#include <gtest/gtest.h>

#include <fstream>

#include "support/small_runs.hpp"

/// What can go wrong with the output folder and during a run, through the program.
namespace {
using namespace talus::support;

Outcome run_into(const std::filesystem::path& folder, Words more = {}, const Limits& limits = {}) {
  std::vector<std::string> arguments{"run",   chute_scene,       "--set", "time.end=0.01",
                                     "--set", "output.times=[]", "--out", folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return outcome_of(TALUS_PROGRAM, arguments, limits);
}

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
  EXPECT_TRUE(says(again, "holds a run already, with a checkpoint at t = 0.01 s: `talus restart " +
                              (folder / "out").string() + "` goes on from there; --force begins anew"))
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

TEST(RunFolder, SolverThatGivesUpNamesTheWorstRowsAndLeavesASummary) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_into(folder / "out", {"--set", "integrator.rtol=1e-13", "--set", "integrator.atol_velocity=1e-16", "--set",
                                "integrator.atol_height=1e-18"});
  EXPECT_EQ(outcome.code, 6);
  EXPECT_TRUE(says(outcome, "worst rows by weighted local error:")) << outcome.output;
  EXPECT_TRUE(says(outcome, ", layer 0 of 32 (x = 0.0")) << outcome.output;
  const auto summary = summary_in(folder / "out");
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_EQ(summary["exit_code"], 6);
  EXPECT_NE(summary["reason"].get<std::string>().find("IDA_ERR_FAIL"), std::string::npos) << summary["reason"];
  EXPECT_NE(summary["integrator"].get<std::string>().find("SUNDIALS IDA"), std::string::npos);
}
}  // namespace
