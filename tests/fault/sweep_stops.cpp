#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "output/folder_lock.hpp"
#include "support/same_run.hpp"
#include "support/signals.hpp"
#include "support/small_runs.hpp"
#include "support/small_sweep.hpp"

/// Members that are stopped or killed, and go on.
namespace {
using talus::support::angles;
using talus::support::contents;
using talus::support::differences_between;
using talus::support::Outcome;
using talus::support::Program;
using talus::support::run_talus;
using talus::support::SmallSweep;
using talus::support::stopped_at_once;
using talus::support::summary_in;
using talus::support::wait_until;
namespace fs = std::filesystem;

constexpr int n_members = 3, restartable = 75;
constexpr double checkpoint_interval = 1e-3;
/// Ten million steps: none ends by itself before the test has done with it.
const std::string endless =
    "\"time.end=100\", \"integrator.max_step=1e-5\", \"checkpoint.interval=1e-3\", \"output.times=[]\", "
    "\"output.series_interval=1e-3\"";

bool has_checkpoint(const fs::path& folder) {
  std::error_code error;
  return std::ranges::any_of(fs::directory_iterator(folder, error),
                             [](const fs::directory_entry& entry) { return entry.path().extension() == ".sha256"; });
}

template <class Condition>
bool wait_for_members(const SmallSweep& sweep, Condition&& condition) {
  return wait_until([&] {
    for (int i = 0; i < n_members; ++i)
      if (!condition(sweep.member(i))) return false;
    return true;
  });
}

void expect_all_stopped(const SmallSweep& sweep) {
  const auto manifest = nlohmann::json::parse(contents(sweep.folder() / "manifest.json"));
  for (int i = 0; i < n_members; ++i) {
    EXPECT_EQ(manifest["members"][i]["status"], "stopped") << i;
    EXPECT_EQ(manifest["members"][i]["exit_code"], restartable) << i;
    EXPECT_EQ(sweep.summary(i)["exit_code"], restartable) << i;
    EXPECT_NO_THROW(talus::output::FolderLock(sweep.member(i), "a member")) << i << " runs on";
  }
}

TEST(SweepStops, StoppedMembersGoOnAndEndWithTheBitsOfOthers) {
  const SmallSweep sweep(angles, endless), whole(angles, endless);
  Program program(TALUS_PROGRAM, sweep.command({"--jobs", "3"}));
  ASSERT_TRUE(wait_for_members(sweep, has_checkpoint)) << program.output();
  program.send(SIGTERM);
  ASSERT_EQ(program.wait(), restartable) << program.output();
  expect_all_stopped(sweep);

  std::vector<double> saved;
  for (int i = 0; i < n_members; ++i) saved.push_back(sweep.summary(i)["checkpoint_seconds"]);
  const double end = std::ranges::max(saved) + 2.0 * checkpoint_interval;
  const std::string nearer = "time.end=" + nlohmann::json(end).dump();
  for (int i = 0; i < n_members; ++i) {
    const Outcome shortened =
        stopped_at_once(TALUS_PROGRAM, {"restart", sweep.member(i).string(), "--set", nearer, "--allow", "time.end"});
    ASSERT_EQ(shortened.code, restartable) << shortened.output;
  }

  const Outcome rest = sweep.sweep({"--set", nearer});
  ASSERT_EQ(rest.code, 0) << rest.output;
  EXPECT_NE(rest.output.find("3 finished (0 of them before)"), std::string::npos) << rest.output;
  ASSERT_EQ(whole.sweep({"--set", nearer}).code, 0);
  for (int i = 0; i < n_members; ++i) {
    EXPECT_EQ(sweep.summary(i)["continued_from"], nlohmann::json::array({saved[i]})) << i;
    EXPECT_GT(saved[i], 0.0);
    EXPECT_EQ(differences_between(sweep.member(i), whole.member(i)), "") << i;
  }
}

TEST(SweepStops, MembersThatHaveJustBeenStartedHearTheSignal) {
  const SmallSweep sweep(angles, endless);
  Program program(TALUS_PROGRAM, sweep.command({"--jobs", "3"}));
  ASSERT_TRUE(wait_for_members(sweep, [](const fs::path& member) { return fs::exists(member / "console.log"); }));
  program.send(SIGTERM);
  ASSERT_EQ(program.wait(), restartable) << program.output();
  expect_all_stopped(sweep);
}

TEST(SweepStops, AKilledMemberGoesOnFromItsCheckpoint) {
  const SmallSweep sweep(angles, endless);
  ASSERT_EQ(sweep.sweep({"--write", "gnu-parallel"}).code, 0);
  Program member(TALUS_PROGRAM, sweep.member_command(1));
  ASSERT_TRUE(wait_until([&] { return has_checkpoint(sweep.member(1)); })) << member.output();
  member.send(SIGKILL);
  member.wait();
  ASSERT_FALSE(fs::exists(sweep.member(1) / "summary.json"));

  Program program(TALUS_PROGRAM, sweep.command({"--jobs", "3"}));
  ASSERT_TRUE(wait_for_members(sweep, [](const fs::path& folder) { return fs::exists(folder / "console.log"); }));
  program.send(SIGTERM);
  ASSERT_EQ(program.wait(), restartable) << program.output();
  EXPECT_EQ(sweep.summary(0)["continued_from"].size(), 0U);
  ASSERT_EQ(sweep.summary(1)["continued_from"].size(), 1U);
  EXPECT_GT(sweep.summary(1)["continued_from"][0], 0.0);
}

TEST(SweepStops, AMemberWhoseCheckpointIsDamagedBeginsAnewAndSaysSo) {
  const SmallSweep sweep(angles);
  ASSERT_EQ(sweep.sweep({"--write", "gnu-parallel"}).code, 0);
  ASSERT_EQ(stopped_at_once(TALUS_PROGRAM, sweep.member_command(2)).code, restartable);
  ASSERT_TRUE(has_checkpoint(sweep.member(2)));
  std::ofstream(sweep.member(2) / "checkpoint_000001.nc", std::ios::app) << "x";
  const Outcome anew = run_talus(sweep.member_command(2));
  EXPECT_EQ(anew.code, 0);
  EXPECT_NE(
      anew.output.find("members/0002: checkpoint_000001.nc does not agree with its checksum, and no other checkpoint "
                       "is whole: it begins anew"),
      std::string::npos)
      << anew.output;
  EXPECT_EQ(sweep.summary(2)["continued_from"].size(), 0U);
}
}  // namespace
