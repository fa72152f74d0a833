#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "output/folder_lock.hpp"
#include "support/program.hpp"
#include "support/same_data.hpp"

/// Sweeps that meet with what happens in a night: members that fail, signals, kills, changed files.
namespace {
using talus::support::contents;
using talus::support::differing_variables;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::Program;
using talus::support::TemporaryFolder;
namespace fs = std::filesystem;

constexpr int members_failed = 9, restartable = 75;

bool says(const std::string& output, const std::string& words) { return output.find(words) != std::string::npos; }

/// Sweeps over a chute of 4 x 8 cells that runs for a few hundredths of a second.
class Sweep : public testing::Test {
 protected:
  /// Writes the sweep file; `settings` as in "\"time.end=0.02\", ...".
  void write(const std::string& axes, const std::string& settings = "\"time.end=0.02\"") {
    std::ofstream(folder_ / "s.toml") << "[sweep]\nname = \"s\"\nscene = \"" TALUS_SOURCE_DIR
                                      << "/runs/examples/chute_periodic.toml\"\nset = [\"grid.layers=8\", "
                                         "\"output.times=[]\", "
                                      << settings << "]\n"
                                      << axes;
  }
  [[nodiscard]] std::vector<std::string> command(const std::string& out, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"sweep", (folder_ / "s.toml").string(), "--out", (folder_ / out).string()});
    return more;
  }
  [[nodiscard]] Outcome sweep(const std::string& out = "out", const std::vector<std::string>& more = {}) const {
    return outcome_of(TALUS_PROGRAM, command(out, more));
  }
  [[nodiscard]] fs::path member(int number, const std::string& out = "out") const {
    return folder_ / out / "members" / ("000" + std::to_string(number));
  }
  [[nodiscard]] nlohmann::json manifest(const std::string& out = "out") const {
    return nlohmann::json::parse(contents(folder_ / out / "manifest.json"));
  }
  [[nodiscard]] std::string status(int number, const std::string& out = "out") const {
    return manifest(out)["members"][number]["status"];
  }
  /// The number of lines of a member's console that begin like a run's report.
  [[nodiscard]] std::ptrdiff_t attempts(int number) const {
    std::ifstream in(member(number) / "console.log");
    std::ptrdiff_t n = 0;
    for (std::string line; std::getline(in, line);)
      n += line.starts_with("talus: ") || says(line, ": finished") ? 1 : 0;
    return n;
  }

  const std::string angles_ = "[[axis]]\nkey = \"box.tilt\"\nvalues = [38, 40, 42, 44]\n";
  // about a second and a half each
  const std::string long_ = "\"time.end=0.02\", \"integrator.max_step=1e-5\"";
  TemporaryFolder folder_;
};

TEST_F(Sweep, SkipsWhatIsFinished) {
  write(angles_);
  ASSERT_EQ(sweep().code, 0);
  const auto before = fs::last_write_time(member(2) / "summary.json");
  fs::remove(member(1) / "summary.json");  // as after a kill

  const Outcome again = sweep();
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_TRUE(says(again.output, "4 finished (3 of them before)")) << again.output;
  EXPECT_EQ(fs::last_write_time(member(2) / "summary.json"), before);
  EXPECT_TRUE(fs::exists(member(1) / "summary.json"));
}

TEST_F(Sweep, TriesAFailedMemberOnceMoreAndReportsIt) {
  const auto zipped = [](const std::string& key, const std::string& values) {
    return "[[axis]]\nkey = \"integrator." + key + "\"\nvalues = " + values + "\nzip = \"tolerance\"\n";
  };
  write(zipped("rtol", "[1e-4, 1e-13, 1e-3]") + zipped("atol_velocity", "[1e-5, 1e-16, 1e-5]") +
        zipped("atol_height", "[1e-6, 1e-18, 1e-6]"));
  const Outcome outcome = sweep("out", {"--jobs", "2"});
  EXPECT_EQ(outcome.code, members_failed) << outcome.output;
  EXPECT_TRUE(says(outcome.output, "member 1 failed (")) << outcome.output;
  EXPECT_TRUE(says(outcome.output, "will be tried once more: integrator.rtol = 1e-13")) << outcome.output;
  EXPECT_TRUE(says(outcome.output, "members/0001 failed with exit code 6: integrator.rtol = 1e-13")) << outcome.output;
  EXPECT_TRUE(says(outcome.output, "3 members: 2 finished (0 of them before), 1 failed")) << outcome.output;
  EXPECT_EQ(attempts(0), 1);
  EXPECT_EQ(attempts(1), 2);
  EXPECT_EQ(status(1), "failed");
  EXPECT_EQ(manifest()["members"][1]["exit_code"], 6);
  EXPECT_TRUE(says(manifest()["members"][1]["reason"], "IDA_"));
  EXPECT_EQ(status(2), "finished");
}

TEST_F(Sweep, RefusesBadMembersBeforeAnyRun) {
  write(
      "[[axis]]\nkey = \"rheology.mu_s\"\nvalues = [0.4, 0.95]\n[[axis]]\nkey = \"rheology.mu_d\"\nvalues = [0.9, "
      "1.0]\n");
  const Outcome outcome = sweep();
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(says(outcome.output,
                   "s.toml: 1 of 4 members are refused, none was run\n"
                   "member 2 (rheology.mu_s = 0.95, rheology.mu_d = 0.9):\n"))
      << outcome.output;
  EXPECT_TRUE(says(outcome.output, "rheology.law: classical: mu_d = 0.9 must be")) << outcome.output;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Sweep, ToldADryRunRunsNothing) {
  write(angles_);
  const Outcome outcome = sweep("out", {"--dry-run"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(says(outcome.output, "s: 4 members, all scenes checked\n  box_tilt: 4\n")) << outcome.output;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Sweep, GivesTheSameBitsForAnyNumberOfJobsAndAnyOrder) {
  write(angles_ + "[[axis]]\nkey = \"integrator.linear_solver\"\nvalues = [\"automatic\", \"condensed\"]\n");
  ASSERT_EQ(sweep("one", {"--jobs", "1"}).code, 0);
  ASSERT_EQ(sweep("three", {"--jobs", "3"}).code, 0);
  const std::string backwards = (folder_ / "backwards").string();
  fs::create_directories(folder_ / "backwards" / "scenes");
  fs::copy(folder_ / "one" / "scenes", folder_ / "backwards" / "scenes");
  fs::copy(folder_ / "one" / "manifest.json", folder_ / "backwards");
  for (int i = 7; i >= 0; --i) ASSERT_EQ(outcome_of(TALUS_PROGRAM, {"member", backwards, std::to_string(i)}).code, 0);
  for (int i = 0; i < 8; ++i) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(differing_variables(member(i, "one") / "run.nc", member(i, "three") / "run.nc"), Names{});
    EXPECT_EQ(differing_variables(member(i, "one") / "run.nc", member(i, "backwards") / "run.nc"), Names{});
  }
  EXPECT_FALSE(differing_variables(member(0, "one") / "run.nc", member(2, "one") / "run.nc").empty());
}

TEST_F(Sweep, AMemberAloneIsRunOnceAndOnlyIfThereIsOne) {
  write(angles_);
  ASSERT_EQ(sweep().code, 0);
  const std::string out = (folder_ / "out").string();
  const Outcome again = outcome_of(TALUS_PROGRAM, {"member", out, "3"});
  EXPECT_EQ(again.code, 0);
  EXPECT_TRUE(says(again.output, "members/0003: finished before")) << again.output;
  EXPECT_EQ(outcome_of(TALUS_PROGRAM, {"member", out, "4"}).code, 2);
  EXPECT_EQ(outcome_of(TALUS_PROGRAM, {"member", folder_.path().string(), "0"}).code, 2);
}

TEST_F(Sweep, DoesNotTakeRunsOfAnotherSceneForItsOwn) {
  write(angles_);
  ASSERT_EQ(sweep().code, 0);
  write("[[axis]]\nkey = \"box.tilt\"\nvalues = [38, 41, 42, 44]\n");
  const Outcome refused = sweep();
  EXPECT_EQ(refused.code, 3);
  EXPECT_TRUE(says(refused.output, "0001 holds a run of another scene than member 1 (box.tilt = 41.0 degree); --force"))
      << refused.output;
  EXPECT_EQ(status(1), "finished");

  const Outcome forced = sweep("out", {"--force"});
  EXPECT_EQ(forced.code, 0);
  EXPECT_TRUE(says(forced.output, "4 finished (3 of them before)")) << forced.output;
  EXPECT_TRUE(says(contents(member(1) / "scene.toml"), "tilt = 41.0"));
}

TEST_F(Sweep, FolderThatCannotBeMadeIsRefused) {
  write(angles_);
  std::ofstream(folder_ / "file") << "not a folder";
  EXPECT_EQ(sweep("file").code, 3);
}

/// A sweep of members that run for a second or two.
class LongSweep : public Sweep {
 protected:
  void SetUp() override {
    write(angles_, long_);
    program_ = std::make_unique<Program>(TALUS_PROGRAM, command("out", {"--jobs", "2"}));
  }
  /// Until the sweep has told of so many members.
  void wait_for_members(int n) {
    for (int i = 0; i < 3000 && std::ranges::count(program_->output(), '\n') < n && program_->running(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(program_->running()) << program_->output();
  }
  std::unique_ptr<Program> program_;
};

TEST_F(LongSweep, LocksItsFolder) {
  wait_for_members(1);
  const Outcome second = sweep();
  EXPECT_EQ(second.code, 7);
  EXPECT_TRUE(says(second.output, "another sweep is writing to it")) << second.output;
}

TEST_F(LongSweep, KilledLeavesMembersThatTheNextCallDoesNotDisturb) {
  wait_for_members(1);
  program_->send(SIGKILL);
  EXPECT_EQ(program_->wait(), 1000 + SIGKILL);
  Outcome next = sweep();
  EXPECT_TRUE(next.code == 0 || next.code == restartable) << next.output;
  EXPECT_TRUE(says(next.output, " 0 failed")) << next.output;
  for (int i = 0; i < 20 && next.code == restartable; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    next = sweep();
  }
  EXPECT_EQ(next.code, 0) << next.output;
}
}  // namespace
