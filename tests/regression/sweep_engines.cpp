#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "support/signals.hpp"
#include "support/small_sweep.hpp"

/// Scripts for other engines: with the real GNU parallel, and Slurm's under a stand-in for its environment.
namespace {
using talus::support::angles;
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::Program;
using talus::support::SmallSweep;
using talus::support::stopped_at_once;
using talus::support::TemporaryFolder;
namespace fs = std::filesystem;

/// Runs a command of the shell's PATH.
Outcome shell(const std::string& command, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"-c", command, "sh"});
  return outcome_of("/bin/sh", arguments);
}

void write_program(const fs::path& file, const std::string& text) {
  std::ofstream(file) << "#!/bin/sh\n" << text << "\n";
  fs::permissions(file, fs::perms::owner_all);
}

std::size_t lines_in(const fs::path& file) {
  const std::string text = contents(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(GnuParallel, RunsWhatIsNotFinishedAndKeepsALog) {
  const SmallSweep sweep(angles);
  const Outcome written = sweep.sweep({"--write", "gnu-parallel"});
  ASSERT_EQ(written.code, 0) << written.output;
  EXPECT_FALSE(sweep.finished(0));
  const std::string script = (sweep.folder() / "run_parallel.sh").string();
  ASSERT_EQ(outcome_of(TALUS_PROGRAM, {"member", sweep.folder().string(), "1"}).code, 0);
  const auto before = fs::last_write_time(sweep.folder() / "members/0001/summary.json");

  const Outcome outcome = outcome_of(script, {"--jobs", "2"});
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(sweep.finished(i)) << i;
  EXPECT_EQ(fs::last_write_time(sweep.folder() / "members/0001/summary.json"), before);
  EXPECT_EQ(lines_in(sweep.folder() / "parallel.log"), 4U);
  EXPECT_FALSE(fs::exists(sweep.folder() / "x"));

  const Outcome again = outcome_of(script, {});
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(lines_in(sweep.folder() / "parallel.log"), 4U);
}

TEST(GnuParallel, TriesAFailedMemberOnceMoreAndSaysSo) {
  const SmallSweep sweep(angles);
  ASSERT_EQ(sweep.sweep({"--write", "gnu-parallel"}).code, 0);
  const TemporaryFolder folder;
  write_program(folder / "talus", "echo $3 >>called; [ $3 != 1 ] || exit 6; exec " TALUS_PROGRAM " \"$@\"");
  const Outcome outcome = shell("TALUS=\"$1\" exec \"$2\" --jobs 1",
                                {(folder / "talus").string(), (sweep.folder() / "run_parallel.sh").string()});
  EXPECT_EQ(outcome.code, 1) << outcome.output;
  std::string called = contents(sweep.folder() / "called");
  EXPECT_EQ(std::count(called.begin(), called.end(), '1'), 2) << called;
  EXPECT_EQ(called.size(), 8U) << called;
  EXPECT_TRUE(sweep.finished(0));
  EXPECT_TRUE(sweep.finished(2));
}

TEST(GnuParallel, GoesOnWithAStoppedMember) {
  const SmallSweep sweep(angles);
  ASSERT_EQ(sweep.sweep({"--write", "gnu-parallel"}).code, 0);
  ASSERT_EQ(stopped_at_once(TALUS_PROGRAM, sweep.member_command(1)).code, 75);
  const Outcome outcome = outcome_of((sweep.folder() / "run_parallel.sh").string(), {"--jobs", "2"});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_EQ(sweep.summary(1)["continued_from"], nlohmann::json::array({0.0}));
  EXPECT_EQ(sweep.summary(0)["continued_from"].size(), 0U);
}

TEST(Scripts, ContentBashAndShellcheck) {
  const SmallSweep sweep(angles);
  for (const char* engine : {"gnu-parallel", "slurm"}) ASSERT_EQ(sweep.sweep({"--write", engine}).code, 0);
  for (const char* script : {"run_parallel.sh", "run_slurm.sh"}) {
    const std::string file = (sweep.folder() / script).string();
    EXPECT_EQ(shell("bash -n \"$1\"", {file}).code, 0);
    const Outcome checked = shell("shellcheck \"$1\"", {file});
    EXPECT_EQ(checked.code, 0) << checked.output;
  }
}

/// The script of a job array, started as Slurm would: copied elsewhere, with a scontrol that only notes what it was asked.
class JobArray : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(sweep_.sweep({"--write", "slurm"}).code, 0);
    write_program(spool_ / "scontrol", "echo \"$@\" >\"$SCONTROL_LOG\"");
    fs::copy(sweep_.folder() / "run_slurm.sh", spool_ / "slurm_script");
  }
  /// `talus`: another program in place of talus, or "".
  [[nodiscard]] std::vector<std::string> task(int number, const std::string& talus = "") const {
    return {
        "-c",
        "cd / && PATH=\"$1:$PATH\" SCONTROL_LOG=\"$1/asked\" SLURM_ARRAY_JOB_ID=77 SLURM_ARRAY_TASK_ID=\"$2\" && "
        "export "
        "PATH SCONTROL_LOG SLURM_ARRAY_JOB_ID SLURM_ARRAY_TASK_ID && [ -z \"$3\" ] || export TALUS=\"$3\"; exec bash "
        "\"$1/slurm_script\"",
        "sh",
        spool_.path().string(),
        std::to_string(number),
        talus};
  }
  [[nodiscard]] std::string log(int number) const {
    return contents(sweep_.folder() / "logs" / ("task_" + std::to_string(number) + ".log"));
  }
  [[nodiscard]] std::string asked() const { return contents(spool_ / "asked"); }

  SmallSweep sweep_{angles};
  TemporaryFolder spool_;
};

TEST_F(JobArray, RunsTheMemberOfItsTask) {
  EXPECT_EQ(outcome_of("/bin/sh", task(1)).code, 0) << log(1);
  EXPECT_TRUE(sweep_.finished(1));
  EXPECT_FALSE(sweep_.finished(0));
  EXPECT_EQ(outcome_of("/bin/sh", task(1)).code, 0);
  EXPECT_NE(log(1).find("members/0001: finished before"), std::string::npos) << log(1);
  EXPECT_EQ(asked(), "");
  EXPECT_FALSE(fs::exists(sweep_.folder() / "x"));
}

TEST_F(JobArray, TriesAFailedMemberOnceMore) {
  write_program(spool_ / "talus", "echo called \"$@\"; exit 6");
  EXPECT_EQ(outcome_of("/bin/sh", task(2, (spool_ / "talus").string())).code, 9);
  EXPECT_EQ(log(2),
            "called member . 2\nmember 2: attempt 1 ended with code 6\ncalled member . 2\n"
            "member 2: attempt 2 ended with code 6\n");
  EXPECT_EQ(asked(), "");
}

TEST_F(JobArray, GoesOnWithAStoppedMember) {
  ASSERT_EQ(stopped_at_once(TALUS_PROGRAM, sweep_.member_command(1)).code, 75);
  ASSERT_EQ(outcome_of("/bin/sh", task(1)).code, 0) << log(1);
  EXPECT_EQ(sweep_.summary(1)["continued_from"], nlohmann::json::array({0.0}));
}

TEST_F(JobArray, QueuesItselfAgainWhereTheMemberCouldNotAnswerYet) {
  write_program(spool_ / "talus", "echo ready; while :; do sleep 0.05; done");
  Program job("/bin/sh", task(2, (spool_ / "talus").string()));
  for (int i = 0; i < 500 && log(2).empty(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  job.send(SIGTERM);
  EXPECT_EQ(job.wait(), 75);
  EXPECT_EQ(log(2), "ready\n");
  EXPECT_EQ(asked(), "requeue 77_2\n");
}

TEST_F(JobArray, PassesTheSignalOnAndQueuesItselfAgain) {
  // It ends some time after the signal, as a run that writes a checkpoint.
  write_program(spool_ / "talus",
                "trap 'echo told; sleep 0.3; exit 75' TERM; echo ready; while :; do sleep 0.05; done");
  Program job("/bin/sh", task(2, (spool_ / "talus").string()));
  for (int i = 0; i < 500 && log(2).empty(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  job.send(SIGTERM);
  EXPECT_EQ(job.wait(), 75);
  EXPECT_EQ(log(2), "ready\ntold\n");
  EXPECT_EQ(asked(), "requeue 77_2\n");
}
}  // namespace
