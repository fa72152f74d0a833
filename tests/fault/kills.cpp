#include <gtest/gtest.h>

#include <random>

#include "support/same_run.hpp"
#include "support/small_runs.hpp"

/// Power cuts in the small: runs ended by SIGKILL at random moments, each continued until it ends.
namespace {
using namespace talus::support;

constexpr int n_kills = 25;

/// How many checkpoints the log of a run speaks of.
std::size_t n_checkpoints(const std::filesystem::path& folder) {
  const std::string log = contents(folder / "run.log"), words = "checkpoint_";
  std::size_t n = 0;
  for (auto at = log.find(words); at != std::string::npos; at = log.find(words, at + 1)) ++n;
  return n;
}

TEST(Kills, ARunKilledAtRandomMomentsEndsWithTheBitsOfOneThatWasNot) {
  const TemporaryFolder folder;
  const Words exact{"checkpoint.interval=0.5", "integrator.linear_solver=automatic"};
  ASSERT_EQ(run_talus(small_heap(folder / "whole", exact)).code, 0);

  // A kill comes some checkpoints after the start, so that a busy machine does not get stuck before the first one, and
  // some milliseconds after that; every fifth one comes any time after the start.
  std::mt19937 random(8);
  const auto up_to = [&](int n) { return std::uniform_int_distribution<int>(0, n)(random); };
  int kills = 0, after_a_checkpoint = 0;
  for (int run = 0; kills < n_kills; ++run) {
    const auto out = folder / ("killed" + std::to_string(run));
    while (true) {
      const std::size_t before = n_checkpoints(out);
      const bool begun = std::filesystem::exists(out / "scene.toml");
      Program program(TALUS_PROGRAM, begun ? Words{"restart", out.string()} : small_heap(out, exact));
      if (kills < n_kills) {
        if (kills % 5 != 0) {
          const std::size_t enough = before + 1 + static_cast<std::size_t>(up_to(2));
          ASSERT_TRUE(wait_until([&] { return n_checkpoints(out) >= enough || !program.running(); }));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(up_to(kills % 5 != 0 ? 30 : 300)));
        if (program.running()) {
          program.send(SIGKILL);
          program.wait();
          ++kills;
          after_a_checkpoint += n_checkpoints(out) > before ? 1 : 0;
          continue;
        }
      }
      ASSERT_EQ(program.wait(), 0) << program.output();
      break;
    }
    EXPECT_EQ(differences_between(folder / "whole", out), "") << "after " << kills << " kills";
    const auto times = NcReader(out / "run.nc").values("series_time");
    EXPECT_TRUE(std::ranges::is_sorted(times, std::less_equal{})) << "a time twice, or out of order";
  }
  EXPECT_GT(after_a_checkpoint, n_kills / 2);
  RecordProperty("after_a_checkpoint", after_a_checkpoint);
}

TEST(Kills, WhatWasRecordedBeforeTheKillIsReadable) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  Program program(TALUS_PROGRAM, long_chute(out));
  ASSERT_TRUE(wait_for_log(out, "t = 0.0005 s")) << program.output();
  program.send(SIGKILL);
  program.wait();
  const NcReader run(out / "run.nc");
  const auto times = run.values("series_time"), mass = run.values("mass_stored");
  ASSERT_GE(times.size(), 6U);
  EXPECT_EQ(times[5], 5e-4);
  EXPECT_TRUE(std::ranges::all_of(mass, [&](double m) { return m == mass[0] || std::abs(m - mass[0]) < 1e-9; }));
}
}  // namespace
