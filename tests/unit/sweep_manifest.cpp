#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/errors.hpp"
#include "output/checkpoint_folder.hpp"
#include "output/text_file.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/manifest.hpp"
#include "sweep/runner.hpp"
#include "sweep/sweep_folder.hpp"

namespace {
using namespace talus;
using namespace talus::sweep;

Manifest sample() {
  Design design({{"law_name", {{"law.name", "", "which", {std::string("a, \"b\""), std::string("c")}}}},
                 {"grid",
                  {{"grid.columns", "", "", {std::int64_t{10}, std::int64_t{20}}},
                   {"box.gap", "m", "between the walls", {0.1, 2.0}}}}});
  return {"s",
          "a sweep",
          "s.toml",
          std::move(design),
          {{},
           {Status::finished, 0, "", true, false, ""},
           {Status::failed, 6, "gave up\nat 3 s", true, false, ""},
           {Status::stopped, 75, "signal 15", true, true, ""}}};
}

TEST(Manifest, ReadsBackToItself) {
  const support::TemporaryFolder folder;
  write_manifest(folder.path(), sample());
  const Manifest read = read_manifest(folder.path());
  EXPECT_EQ(read.name, "s");
  EXPECT_EQ(read.title, "a sweep");
  ASSERT_EQ(read.design.size(), 4U);
  const Manifest written = sample();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read.design.describe(i), written.design.describe(i));
    EXPECT_EQ(read.members[i].status, written.members[i].status);
    EXPECT_EQ(read.members[i].exit_code, written.members[i].exit_code);
    EXPECT_EQ(read.members[i].reason, written.members[i].reason);
  }
  EXPECT_EQ(read.design.dimensions()[1].axes[1].doc, "between the walls");
  EXPECT_TRUE(std::holds_alternative<std::int64_t>(read.design.dimensions()[1].axes[0].values[0]));
  EXPECT_TRUE(std::holds_alternative<double>(read.design.dimensions()[1].axes[1].values[1]));
}

TEST(Manifest, HasARowForEachMember) {
  const support::TemporaryFolder folder;
  write_manifest(folder.path(), sample());
  EXPECT_EQ(output::contents(folder / "manifest.csv"),
            "member,folder,law.name,grid.columns,box.gap [m],status,exit_code\n"
            "0,members/0000,\"a, \"\"b\"\"\",10,0.1,planned,\n"
            "1,members/0001,\"a, \"\"b\"\"\",20,2.0,finished,0\n"
            "2,members/0002,c,10,0.1,failed,6\n"
            "3,members/0003,c,20,2.0,stopped,75\n");
}

TEST(Manifest, ThatIsNoneIsRefused) {
  const support::TemporaryFolder folder;
  EXPECT_THROW((void)read_manifest(folder.path()), core::ConfigError);
  for (const char* text : {"", "[]", "{\"format\": 99}", "{\"format\": 1, \"sweep\": 3}"}) {
    std::ofstream(folder / "manifest.json") << text;
    EXPECT_THROW((void)read_manifest(folder.path()), core::ConfigError) << text;
  }
}

TEST(SweepFolder, CountsWithAsManyDigitsAsTheLastMemberNeeds) {
  EXPECT_EQ(SweepFolder("", 1).member(0), "members/0000");
  EXPECT_EQ(SweepFolder("", 10000).scene(9999), "scenes/9999.toml");
  EXPECT_EQ(SweepFolder("", 10001).member(7), "members/00007");
}

class MemberFolder : public testing::Test {
 protected:
  MemberState with(const std::string& summary, const std::string& scene = "a = 1\n") {
    std::ofstream(folder_ / "scene.toml") << scene;
    std::ofstream(folder_ / "summary.json") << summary;
    return member_state(folder_.path(), "a = 1\n");
  }
  void save(const std::string& scene) {
    output::Checkpoint checkpoint;
    checkpoint.y = checkpoint.yp = {1.0};
    checkpoint.fields = {"u"};
    checkpoint.field_of = {0};
    checkpoint.scene = scene;
    output::CheckpointFolder(folder_.path()).write(checkpoint);
  }
  void damage(const char* name) { std::ofstream(folder_ / name, std::ios::app) << "x"; }
  support::TemporaryFolder folder_;
};

TEST_F(MemberFolder, SaysWhatBecameOfTheRun) {
  EXPECT_EQ(member_state(folder_.path(), "").status, Status::planned);
  EXPECT_EQ(with("").status, Status::unfinished);
  EXPECT_EQ(with("{\"status\": \"fin").status, Status::unfinished);
  EXPECT_EQ(with("{\"status\": \"finished\", \"exit_code\": 0, \"reason\": null}").status, Status::finished);
  const MemberState failed = with("{\"status\": \"failed\", \"exit_code\": 6, \"reason\": \"it broke\"}");
  EXPECT_EQ(failed.status, Status::failed);
  EXPECT_EQ(failed.exit_code, 6);
  EXPECT_EQ(failed.reason, "it broke");
  EXPECT_TRUE(failed.same_scene);
}

const std::string killed,
    stopped = "{\"status\": \"stopped\", \"exit_code\": 75}", disk_full = "{\"status\": \"failed\", \"exit_code\": 5}",
    failed = "{\"status\": \"failed\", \"exit_code\": 6}", finished = "{\"status\": \"finished\", \"exit_code\": 0}";

TEST_F(MemberFolder, WithoutACheckpointBeginsAnewUnlessFinished) {
  EXPECT_EQ(next_action(MemberState{}), Action::run);
  for (const auto& summary : {killed, stopped, disk_full, failed}) EXPECT_EQ(next_action(with(summary)), Action::run);
  EXPECT_EQ(next_action(with(finished)), Action::skip);
  EXPECT_EQ(next_action(with(finished, "a = 2\n")), Action::run);
}

TEST_F(MemberFolder, GoesOnFromItsCheckpointUnlessItFailedByItself) {
  save("a = 1\n");
  for (const auto& summary : {killed, stopped, disk_full}) EXPECT_EQ(next_action(with(summary)), Action::restart);
  EXPECT_EQ(next_action(with(failed)), Action::run);
  EXPECT_EQ(next_action(with(finished)), Action::skip);
  EXPECT_EQ(next_action(with(stopped, "a = 2\n")), Action::run);
}

TEST_F(MemberFolder, DoesNotGoOnFromACheckpointOfAnotherScene) {
  save("a = 2\n");
  EXPECT_EQ(next_action(with(stopped)), Action::run);
}

TEST_F(MemberFolder, GoesOnAsLongAsOneCheckpointIsWhole) {
  save("a = 1\n");
  save("a = 1\n");
  damage("checkpoint_000002.nc");
  EXPECT_EQ(next_action(with(stopped)), Action::restart);
  EXPECT_EQ(with(stopped).damage, "");
  damage("checkpoint_000001.nc");
  EXPECT_EQ(next_action(with(stopped)), Action::run);
  EXPECT_EQ(with(stopped).damage, "checkpoint_000002.nc does not agree with its checksum");
}
}  // namespace
