#include <gtest/gtest.h>

#include "support/same_run.hpp"
#include "support/small_runs.hpp"

/// Runs that are asked to stop, or to save, from outside.
namespace {
using namespace talus::support;

constexpr int restartable = 75;

/// A run that would take minutes, caught while it integrates.
class LongRun : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(wait_for_log(out_, "steps")) << program_.output();
    ASSERT_TRUE(program_.running()) << program_.output();
  }

  TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out";
  Program program_{TALUS_PROGRAM, long_chute(out_)};
};

TEST_F(LongRun, StopsOnASignalWithACheckpointAndSaysHowToGoOn) {
  for (const int signal : {SIGTERM, SIGINT}) {
    if (signal == SIGINT) {  // continued, then stopped again
      Program again(TALUS_PROGRAM, {"restart", out_.string()});
      ASSERT_TRUE(wait_for_log(out_, "goes on from the checkpoint"));
      again.send(signal);
      EXPECT_EQ(again.wait(), restartable) << again.output();
    } else {
      program_.send(signal);
      EXPECT_EQ(program_.wait(), restartable) << program_.output();
    }
    const auto summary = summary_in(out_);
    EXPECT_EQ(summary["status"], "stopped");
    EXPECT_EQ(summary["exit_code"], restartable);
    const auto reason = summary["reason"].get<std::string>();
    EXPECT_TRUE(reason.starts_with(signal == SIGTERM ? "stopped by SIGTERM" : "stopped by SIGINT")) << reason;
    EXPECT_NE(reason.find("`talus restart " + out_.string() + "` goes on from t = "), std::string::npos) << reason;
    EXPECT_GT(summary["simulated_seconds"], 0.0);
    EXPECT_EQ(summary["checkpoint_seconds"], summary["simulated_seconds"]);
    EXPECT_TRUE(std::filesystem::exists(out_ / "checkpoint_000001.nc"));
  }
}

TEST_F(LongRun, LocksItsFolder) {
  for (const Words& other : {long_chute(out_, {}), Words{"restart", out_.string()}}) {
    const Outcome second = run_talus(other);
    EXPECT_EQ(second.code, 7);
    EXPECT_TRUE(says(second, "another run is writing to it")) << second.output;
  }
}

TEST(Stops, ASecondInterruptEndsTheRunAtOnce) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  Program program(TALUS_PROGRAM, with_settings({"run", heap_scene, "--out", out.string()},
                                               {"grid.columns=150", "output.series_interval=1e-3"}));
  ASSERT_TRUE(wait_for_log(out, "steps")) << program.output();
  while (program.running()) {  // a step takes some 25 ms: far longer than it takes to get two signals delivered
    program.send(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(program.wait(), 1000 + SIGINT) << program.output();
}

TEST(Stops, AStopWithAnExactIntervalKeepsTheBits) {
  const TemporaryFolder folder;
  const Words exact{"checkpoint.interval=2"};
  ASSERT_EQ(run_talus(small_heap(folder / "whole", exact)).code, 0);
  const auto out = folder / "stopped";
  Program program(TALUS_PROGRAM, small_heap(out, exact));
  ASSERT_TRUE(wait_for_log(out, "t = 3.3 s")) << program.output();
  program.send(SIGTERM);
  ASSERT_EQ(program.wait(), restartable) << program.output();
  const double stopped = summary_in(out)["simulated_seconds"], kept = summary_in(out)["checkpoint_seconds"];
  EXPECT_EQ(std::fmod(kept, 2.0), 0.0);
  EXPECT_GT(stopped, kept);
  const Outcome restarted = run_talus({"restart", out.string()});
  EXPECT_EQ(restarted.code, 0) << restarted.output;
  EXPECT_EQ(differences_between(folder / "whole", out), "");
  EXPECT_EQ(summary_in(out)["continued_from"], nlohmann::json({kept}));
}

TEST(Stops, AStopBeforeTheFirstCheckpointOfAnExactIntervalBeginsAnew) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const Outcome stopped = run_talus(small_heap(out, {"checkpoint.interval=2", "checkpoint.wall_limit=1e-3"}));
  EXPECT_EQ(stopped.code, restartable);
  EXPECT_TRUE(says(stopped, "stopped at its wall limit of 0.001 s at t = 0 s; `talus restart " + out.string() +
                                "` begins anew: there is no checkpoint yet"))
      << stopped.output;
  const Outcome restarted =
      run_talus({"restart", out.string(), "--set", "checkpoint.wall_limit=1000", "--allow", "checkpoint.wall_limit"});
  EXPECT_EQ(restarted.code, 0) << restarted.output;
  EXPECT_TRUE(says(restarted, "no checkpoint yet, the run begins anew")) << restarted.output;
  ASSERT_EQ(run_talus(small_heap(folder / "whole", {"checkpoint.interval=2"})).code, 0);
  EXPECT_EQ(differences_between(folder / "whole", out), "");
}

TEST(Stops, AStopWithoutAnIntervalLosesNothingAndEndsTheSameWithinTolerance) {
  const TemporaryFolder folder;
  // Precise: at the scene's own rtol two ways through time are up to 4e-4 apart, each 2e-4 from the limit. Poured to the end: a
  // signal that fell into the ramp of a shut-off would compare how two step sequences integrate the ramp.
  const auto pouring = [](const std::filesystem::path& out) {
    return with_settings({"run", heap_scene, "--out", out.string()},
                         {"grid.columns=30", "grid.layers=8", "output.times=[3.3]", "time.end=10", "inflow.stop=1000",
                          "output.interval=1", "output.series_interval=0.1", "integrator.rtol=1e-6",
                          "integrator.atol_velocity=1e-7", "integrator.atol_height=1e-8"});
  };
  ASSERT_EQ(run_talus(pouring(folder / "whole")).code, 0);
  const auto out = folder / "stopped";
  Program program(TALUS_PROGRAM, pouring(out));
  ASSERT_TRUE(wait_for_log(out, "t = 3.3 s")) << program.output();
  program.send(SIGINT);
  ASSERT_EQ(program.wait(), restartable) << program.output();
  const auto stopped = summary_in(out);
  EXPECT_EQ(stopped["checkpoint_seconds"], stopped["simulated_seconds"]);
  EXPECT_EQ(NcReader(out / "run.nc").values("series_time").back(), stopped["simulated_seconds"]);
  const Outcome restarted = run_talus({"restart", out.string()});
  ASSERT_EQ(restarted.code, 0) << restarted.output;
  const auto a = summary_in(folder / "whole")["final"], b = summary_in(out)["final"];
  EXPECT_NEAR(a["mass_stored"], b["mass_stored"], 1e-5 * a["mass_stored"].get<double>());
  EXPECT_LT(std::abs(b["mass_error"].get<double>()), 1e-12);
  EXPECT_GT(summary_in(out)["wall_seconds"], stopped["wall_seconds"]);
  EXPECT_EQ(NcReader(out / "run.nc").values("series_time"), NcReader(folder / "whole" / "run.nc").values("series_time"))
      << "the state at the stop is no record of the continued run";
}

TEST(Stops, ARunAskedToSaveGoesOnWithTheBitsOfOneContinuedFromThere) {
  const TemporaryFolder folder;
  const auto out = folder / "out", copy = folder / "copy";
  Program program(TALUS_PROGRAM, small_heap(out));
  ASSERT_TRUE(wait_for_log(out, "t = 2 s")) << program.output();
  program.send(SIGUSR1);
  ASSERT_EQ(program.wait(), 0) << program.output();
  ASSERT_TRUE(std::filesystem::exists(out / "checkpoint_000002.nc"))
      << "the first by the signal, the second at the end";
  std::filesystem::copy(out, copy);
  std::filesystem::remove(copy / "checkpoint_000002.nc");
  std::filesystem::remove(copy / "summary.json");
  const Outcome restarted = run_talus({"restart", copy.string()});
  ASSERT_EQ(restarted.code, 0) << restarted.output;
  EXPECT_EQ(differences_between(out, copy), "");
  EXPECT_LT(summary_in(copy)["continued_from"][0], 10.0);
}

TEST(Stops, InexactCheckpointsDoNotTouchTheRunThatWritesThem) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_talus(small_heap(folder / "plain")).code, 0);
  ASSERT_EQ(run_talus(small_heap(folder / "saved",
                                 {"checkpoint.exact=false", "checkpoint.wall_interval=0.05", "checkpoint.interval=1"}))
                .code,
            0);
  EXPECT_NE(contents(folder / "saved" / "run.log").find("checkpoint_000008"), std::string::npos);
  EXPECT_EQ(differences_between(folder / "plain", folder / "saved"), "");
}

TEST(Stops, TheWallClockMayJump) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const Outcome outcome =
      outcome_of(TALUS_PROGRAM, small_heap(out, {"checkpoint.wall_limit=1000", "checkpoint.wall_interval=1000"}),
                 {.preload = TALUS_JUMPING_CLOCK});
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_FALSE(std::filesystem::exists(out / "checkpoint_000002.nc")) << "a jump of the clock is no wall time";
  EXPECT_LT(summary_in(out)["wall_seconds"], 1000.0);
  EXPECT_NE(NcReader(out / "run.nc").text("", "history").find("2100-"), std::string::npos) << "the clock did not jump";
}

TEST(Stops, ARunGoesOnWhenNobodyListens) {
  const TemporaryFolder folder;
  const auto in_a_shell = [&](const std::string& script, const std::filesystem::path& out) {
    Words words{"-c", script, TALUS_PROGRAM};
    const Words run = small_heap(out);
    words.insert(words.end(), run.begin(), run.end());
    return outcome_of("/bin/bash", words);
  };
  const Outcome broken = in_a_shell("\"$0\" \"$@\" 2>&1 | true; exit ${PIPESTATUS[0]}", folder / "broken");
  EXPECT_EQ(broken.code, 0) << broken.output;
  const Outcome closed = in_a_shell("\"$0\" \"$@\" <&- >&- 2>&-", folder / "closed");
  EXPECT_EQ(closed.code, 0);
  EXPECT_EQ(differences_between(folder / "broken", folder / "closed"), "");
}
}  // namespace
