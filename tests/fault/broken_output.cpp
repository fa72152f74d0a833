#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "support/same_run.hpp"
#include "support/small_runs.hpp"

/// What happens to a run when its disk or its folder fails it.
namespace {
using namespace talus::support;

constexpr int output_failed = 5;

/// The chute in long steps, recorded densely, so that it soon fills what it has.
Words chatty_chute(const std::filesystem::path& out) {
  return with_settings({"run", chute_scene, "--out", out.string()},
                       {"output.times=[]", "output.series_interval=2e-5", "time.end=0.06", "checkpoint.interval=5e-3"});
}

TEST(BrokenOutput, AFullDiskEndsTheRunWhichGoesOnWhenThereIsRoom) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  constexpr rlim_t room_for_some_records = 17 * 1024 * 1024;  // the writer wants 16 MiB to stay free
  const Outcome full = outcome_of(TALUS_PROGRAM, chatty_chute(out), {.file_size = room_for_some_records});
  ASSERT_EQ(full.code, output_failed) << full.output;
  const auto summary = summary_in(out);
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_EQ(summary["exit_code"], output_failed);
  EXPECT_NE(summary["reason"].get<std::string>().find("disk full"), std::string::npos) << summary["reason"];
  EXPECT_TRUE(says(full, "`talus restart " + out.string() + "` goes on from t = ")) << full.output;
  const auto times = NcReader(out / "run.nc").values("series_time");
  EXPECT_GE(times.back(), summary["checkpoint_seconds"].get<double>()) << "a record older than the checkpoint is lost";
  EXPECT_GT(times.size(), 100U);

  const Outcome restarted = run_talus({"restart", out.string()});
  EXPECT_EQ(restarted.code, 0) << restarted.output;
  ASSERT_EQ(run_talus(chatty_chute(folder / "whole")).code, 0);
  EXPECT_EQ(differences_between(folder / "whole", out), "");
}

/// A run that would take minutes, caught while it integrates; it saves every 2e-4 s and obeys permissions.
class Disturbed : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(wait_for_log(out_, "checkpoint_000002.nc")) << program_.output(); }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::permissions(out_, std::filesystem::perms::owner_all, ignored);
  }

  TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out";
  Program program_{TALUS_PROGRAM, long_chute(out_, {"checkpoint.interval=2e-4"}), {.obeys_permissions = true}};
};

TEST_F(Disturbed, AFolderThatIsRemovedEndsTheRun) {
  std::filesystem::rename(out_, folder_ / "moved");
  EXPECT_EQ(program_.wait(), output_failed);
  const std::string said = program_.output();
  EXPECT_NE(said.find("run.nc was removed or replaced during the run"), std::string::npos) << said;
  EXPECT_NE(said.find("output folder " + out_.string() + ": was removed or replaced during the run"), std::string::npos)
      << said;
  EXPECT_FALSE(std::filesystem::exists(out_)) << "nothing is made anew in its place";
  EXPECT_GE(NcReader(folder_ / "moved" / "run.nc").values("series_time").size(), 5U);
}

TEST_F(Disturbed, AnotherFolderInItsPlaceIsLeftAlone) {
  const auto other = folder_ / "other";  // as of a run that has just begun
  std::filesystem::create_directory(other);
  ASSERT_EQ(renameat2(AT_FDCWD, out_.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE), 0);
  EXPECT_EQ(program_.wait(), output_failed) << program_.output();
  EXPECT_NE(program_.output().find("was removed or replaced during the run"), std::string::npos) << program_.output();
  EXPECT_TRUE(std::filesystem::is_empty(out_)) << "what is there may be another run's";
}

TEST_F(Disturbed, AResultThatIsRemovedEndsTheRun) {
  std::filesystem::remove(out_ / "run.nc");
  EXPECT_EQ(program_.wait(), output_failed);
  EXPECT_NE(summary_in(out_)["reason"].get<std::string>().find("run.nc was removed or replaced during the run"),
            std::string::npos);
}

TEST_F(Disturbed, AFolderThatBecomesReadOnlyEndsTheRunAtItsNextCheckpoint) {
  using std::filesystem::perms;
  std::filesystem::permissions(out_, perms::owner_read | perms::owner_exec);
  EXPECT_EQ(program_.wait(), output_failed);
  const std::string said = program_.output();
  EXPECT_NE(said.find("cannot write " + out_.string() + "/checkpoint_"), std::string::npos) << said;
  EXPECT_NE(said.find("Permission denied"), std::string::npos) << said;
  EXPECT_NE(said.find("cannot write " + (out_ / "summary.json").string()), std::string::npos) << said;
  const Outcome refused = outcome_of(TALUS_PROGRAM, {"restart", out_.string()}, {.obeys_permissions = true});
  EXPECT_EQ(refused.code, 3);
  EXPECT_TRUE(says(refused, "cannot be written to: Permission denied")) << refused.output;

  std::filesystem::permissions(out_, perms::owner_all);
  Program again(TALUS_PROGRAM, {"restart", out_.string()});
  ASSERT_TRUE(wait_for_log(out_, "goes on from the checkpoint"));
  again.send(SIGTERM);
  EXPECT_EQ(again.wait(), 75) << again.output();
}

TEST_F(Disturbed, AReaderThatHoldsTheFileDisturbsNobody) {
  const NcReader during(out_ / "run.nc");
  const auto n = during.values("series_time").size();
  ASSERT_TRUE(wait_for_log(out_, "checkpoint_000004.nc"));
  program_.send(SIGTERM);
  ASSERT_EQ(program_.wait(), 75) << program_.output();
  const NcReader held(out_ / "run.nc");
  const auto before = held.values("series_time");
  Program again(TALUS_PROGRAM, {"restart", out_.string()});
  ASSERT_TRUE(wait_for_log(out_, "checkpoint_000006.nc")) << again.output();
  EXPECT_EQ(held.values("series_time"), before) << "what a reader has open changes under it";
  EXPECT_EQ(during.values("series_time").size(), n);
  EXPECT_GT(NcReader(out_ / "run.nc").values("series_time").size(), n);
}
}  // namespace
