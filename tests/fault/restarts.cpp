#include <gtest/gtest.h>

#include <fstream>

#include "support/same_run.hpp"
#include "support/small_runs.hpp"

/// What `talus restart` accepts, refuses and says.
namespace {
using namespace talus::support;

constexpr int bad_restart = 4;

void replace_in(const std::filesystem::path& file, const std::string& from, const std::string& to) {
  std::string text = contents(file);
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from << " is not in " << file;
  std::ofstream(file) << text.replace(at, from.size(), to);
}

/// A run of the small heap that was stopped on the way, checkpoints at 1, 2, 3 s, ...
class Restart : public testing::Test {
 protected:
  void SetUp() override {
    Program program(TALUS_PROGRAM, small_heap(out, {"checkpoint.interval=1"}));
    ASSERT_TRUE(wait_for_log(out, "checkpoint_000003.nc")) << program.output();
    program.send(SIGTERM);
    ASSERT_EQ(program.wait(), 75) << program.output();
  }
  [[nodiscard]] Outcome restart(const Words& more = {}) const {
    Words words{"restart", out.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_talus(words);
  }
  [[nodiscard]] std::filesystem::path newest() const {
    std::filesystem::path last;
    for (const auto& entry : std::filesystem::directory_iterator(out))
      if (entry.path().extension() == ".nc" && entry.path().filename() != "run.nc") last = std::max(last, entry.path());
    return last;
  }
  void expect_the_bits_of_a_run_that_was_not_stopped(const Words& settings = {}) const {
    Words all{"checkpoint.interval=1"};
    all.insert(all.end(), settings.begin(), settings.end());
    ASSERT_EQ(run_talus(small_heap(folder / "whole", all)).code, 0);
    EXPECT_EQ(differences_between(folder / "whole", out), "");
  }

  TemporaryFolder folder;
  std::filesystem::path out = folder / "out";
};

TEST(RestartOf, NothingIsRefused) {
  const TemporaryFolder folder;
  const Outcome nowhere = run_talus({"restart", (folder / "nowhere").string()});
  EXPECT_EQ(nowhere.code, bad_restart);
  EXPECT_TRUE(says(nowhere, "cannot be opened: No such file or directory")) << nowhere.output;
  EXPECT_FALSE(std::filesystem::exists(folder / "nowhere"));
  const Outcome empty = run_talus({"restart", folder.path().string()});
  EXPECT_EQ(empty.code, bad_restart);
  EXPECT_TRUE(says(empty, "holds no run to go on with (no scene.toml)")) << empty.output;
}

TEST_F(Restart, IsOfferedByRun) {
  const Outcome again = run_talus(small_heap(out));
  EXPECT_EQ(again.code, 3);
  EXPECT_TRUE(says(again, "holds a run already, with a checkpoint at t = ")) << again.output;
  EXPECT_TRUE(says(again, "`talus restart " + out.string() + "` goes on from there")) << again.output;
}

TEST_F(Restart, TakesTheSceneOfTheFolderAndSaysSo) {
  const auto own = folder / "own.toml";
  std::filesystem::copy(heap_scene, own);
  const auto other = folder / "other";
  Words words = small_heap(other, {"checkpoint.interval=1"});
  words[1] = own.string();
  Program program(TALUS_PROGRAM, words);
  ASSERT_TRUE(wait_for_log(other, "checkpoint_000002.nc")) << program.output();
  replace_in(own, "gap = 0.003", "gap = 0.004");
  program.send(SIGTERM);
  ASSERT_EQ(program.wait(), 75);
  const Outcome restarted = run_talus({"restart", other.string()});
  EXPECT_EQ(restarted.code, 0);
  EXPECT_TRUE(says(restarted, "with the scene.toml of that folder, whatever file it came from")) << restarted.output;
  EXPECT_EQ(restart().code, 0);
  EXPECT_EQ(differences_between(out, other), "") << "the change of the scene file got in";
}

TEST_F(Restart, WithAnotherSceneIsRefusedKeyByKey) {
  replace_in(out / "scene.toml", "gap = 0.003", "gap = 0.004");
  const Words changes{"--set", "wall.mu_w=0.4", "--set", "time.end=12"};
  const Outcome refused = restart(changes);
  EXPECT_EQ(refused.code, bad_restart);
  EXPECT_TRUE(says(refused,
                   "was written for another scene (`--allow KEY` lets a key differ):\n"
                   "  box.gap: 0.003 there, 0.004 here\n"
                   "  wall.mu_w: 0.3727 there, 0.4 here\n"
                   "  time.end: 10.0 there, 12.0 here\n"))
      << refused.output;
  Words some = changes;
  some.insert(some.end(), {"--allow", "box.gap", "--allow", "time.end"});
  const Outcome partly = restart(some);
  EXPECT_EQ(partly.code, bad_restart);
  EXPECT_TRUE(says(partly, "lets a key differ):\n  wall.mu_w: 0.3727 there, 0.4 here\n")) << partly.output;
  EXPECT_EQ(summary_in(out)["status"], "stopped") << "a refused restart touches nothing";

  some.insert(some.end(), {"--allow", "wall.mu_w"});
  EXPECT_EQ(restart(some).code, 0);
  EXPECT_EQ(summary_in(out)["simulated_seconds"], 12.0);
  EXPECT_NE(contents(out / "scene.toml").find("mu_w = 0.4"), std::string::npos);
  EXPECT_EQ(restart().code, 0) << "what was allowed once is the run's scene from then on";
}

TEST_F(Restart, OnAnotherGridCannotBeAllowed) {
  const Outcome refused = restart({"--set", "grid.columns=31", "--allow", "grid.columns"});
  EXPECT_EQ(refused.code, bad_restart);
  EXPECT_TRUE(says(refused, "holds the unknowns of another grid or model, which no --allow can bridge"))
      << refused.output;
  const Outcome unknown = restart({"--allow", "grid.colums"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(says(unknown, "--allow: grid.colums: unknown key (did you mean grid.columns?)")) << unknown.output;
  const Outcome early =
      restart({"--set", "time.end=0.5", "--set", "output.times=[]", "--allow", "time.end", "--allow", "output.times"});
  EXPECT_EQ(early.code, bad_restart);
  EXPECT_TRUE(says(early, "time.end = 0.5 s lies before the checkpoint at t = ")) << early.output;
  EXPECT_EQ(restart().code, 0);
}

TEST_F(Restart, ToALaterEndHasTheBitsOfARunOfThatLength) {
  ASSERT_EQ(restart().code, 0);
  const Outcome again = restart();
  EXPECT_EQ(again.code, 0);
  EXPECT_TRUE(says(again, "finished already; to go further: --set time.end=SECONDS --allow time.end")) << again.output;
  EXPECT_EQ(restart({"--set", "time.end=12", "--allow", "time.end"}).code, 0);
  expect_the_bits_of_a_run_that_was_not_stopped({"time.end=12"});
}

TEST_F(Restart, FallsBackFromADamagedCheckpoint) {
  const auto file = newest();
  const std::string whole = contents(file);
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
  for (const auto& damaged : {flipped, whole.substr(0, whole.size() / 2)}) {
    const auto copy = folder / ("damaged" + std::to_string(damaged.size()));
    std::filesystem::copy(out, copy);
    std::ofstream(copy / file.filename(), std::ios::binary) << damaged;
    const Outcome restarted = run_talus({"restart", copy.string()});
    EXPECT_EQ(restarted.code, 0) << restarted.output;
    EXPECT_TRUE(
        says(restarted, file.filename().string() + " does not agree with its checksum; the one before is taken"))
        << restarted.output;
  }
  ASSERT_EQ(restart().code, 0);
  for (const auto size : {whole.size(), whole.size() / 2})
    EXPECT_EQ(differences_between(out, folder / ("damaged" + std::to_string(size))), "");
}

TEST_F(Restart, WithoutAWholeCheckpointIsRefused) {
  for (const auto& entry : std::filesystem::directory_iterator(out))
    if (entry.path().filename().string().starts_with("checkpoint_") && entry.path().extension() == ".nc")
      std::ofstream(entry.path()) << "rubbish";
  const Outcome refused = restart();
  EXPECT_EQ(refused.code, bad_restart);
  EXPECT_TRUE(says(refused,
                   "does not agree with its checksum, and no other checkpoint is whole; `talus run --force` begins "
                   "anew"))
      << refused.output;
}

TEST_F(Restart, WithoutItsRecordsIsRefused) {
  std::ofstream(out / "run.nc") << "rubbish";
  const Outcome rubbish = restart();
  EXPECT_EQ(rubbish.code, bad_restart);
  EXPECT_TRUE(says(rubbish, (out / "run.nc").string() + " cannot be continued: ")) << rubbish.output;
  std::filesystem::remove(out / "run.nc");
  EXPECT_EQ(restart().code, bad_restart);
}
}  // namespace
