#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "core/errors.hpp"
#include "output/checkpoint_folder.hpp"
#include "support/program.hpp"

namespace talus::output {
namespace {

using support::contents;

Checkpoint example(double t) {
  Checkpoint c;
  c.t = t;
  c.y = {1.0 / 3.0, -0.0, 5e-324, 1e300};
  c.yp = {t, 2.0, 3.0, 4.0};
  c.fields = {"u", "p"};
  c.field_of = {0, 1, 0, 1};
  c.statistics.steps = (std::int64_t{1} << 52) + 1;
  c.statistics.restarts = 3;
  c.statistics.order = 4;
  c.statistics.last_step = 0.1;
  c.statistics.seconds_solve = 1.0 / 7.0;
  c.linear_solver = "KLU AMD";
  c.n_records = {12, 345};
  c.scene = "[scene]\nname = \"h\xC3\xB6he\"\n";
  c.summary = std::string(200000, 's');  // beyond what an attribute of HDF5 holds
  c.talus_version = "0.1.0";
  c.revision = "abc";
  return c;
}

TEST(Checkpoint, ReturnsEveryBitThatWasWritten) {
  const Checkpoint a = example(0.1), b = checkpoint_from(to_bytes(a));
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.y, b.y);
  EXPECT_TRUE(std::signbit(b.y[1]));
  EXPECT_EQ(a.yp, b.yp);
  EXPECT_EQ(a.fields, b.fields);
  EXPECT_EQ(a.field_of, b.field_of);
  EXPECT_EQ(a.linear_solver, b.linear_solver);
  EXPECT_EQ(a.n_records, b.n_records);
  EXPECT_EQ(a.scene, b.scene);
  EXPECT_EQ(a.summary, b.summary);
  EXPECT_EQ(a.talus_version, b.talus_version);
  EXPECT_EQ(a.revision, b.revision);
  std::vector<double> before, after;
  core::for_each_counter(a.statistics, [&](const char*, auto x) { before.push_back(static_cast<double>(x)); });
  core::for_each_counter(b.statistics, [&](const char*, auto x) { after.push_back(static_cast<double>(x)); });
  EXPECT_EQ(before, after);
  EXPECT_EQ(b.statistics.steps, a.statistics.steps);
}

TEST(Checkpoint, KnowsTheUnknownsItWasWrittenFor) {
  core::Layout layout{{{"u", "m s-1", core::Kind::differential, 1.0}, {"p", "Pa", core::Kind::algebraic, 1.0}},
                      {0, 1, 0, 1}};
  Checkpoint c;
  c.set_layout(layout);
  EXPECT_TRUE(c.fits(layout));
  layout.field_of.push_back(0);
  EXPECT_FALSE(c.fits(layout));
  layout.field_of = {0, 1, 1, 1};
  EXPECT_FALSE(c.fits(layout));
  layout.field_of = {0, 1, 0, 1};
  layout.fields[1].name = "phi";
  EXPECT_FALSE(c.fits(layout));
}

TEST(Checkpoint, OfANonFiniteStateIsNotWritten) {
  const support::TemporaryFolder folder;
  CheckpointFolder checkpoints(folder.path());
  checkpoints.write(example(1.0));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Checkpoint c = example(2.0);
    c.y[2] = bad;
    EXPECT_THROW(checkpoints.write(c), core::IntegrationError);
    c = example(2.0);
    c.yp[0] = bad;
    EXPECT_THROW(checkpoints.write(c), core::IntegrationError);
    c = example(bad);
    c.yp[0] = 0.0;
    EXPECT_THROW(checkpoints.write(c), core::IntegrationError);
  }
  EXPECT_EQ(checkpoints.newest().checkpoint->t, 1.0);
}

class CheckpointFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const double t : {1.0, 2.0, 3.0}) checkpoints.write(example(t));
  }
  [[nodiscard]] std::filesystem::path file(int number) const {
    return folder / ("checkpoint_00000" + std::to_string(number) + ".nc");
  }
  void expect_the_second(const std::string& complaint) {
    const auto found = checkpoints.newest();
    ASSERT_TRUE(found.checkpoint);
    EXPECT_EQ(found.checkpoint->t, 2.0);
    EXPECT_EQ(found.file, "checkpoint_000002.nc");
    EXPECT_EQ(found.damaged, std::vector<std::string>{"checkpoint_000003.nc " + complaint});
  }

  support::TemporaryFolder folder;
  CheckpointFolder checkpoints{folder.path()};
};

TEST_F(CheckpointFolderTest, KeepsTheLastTwoAndReadsTheNewest) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"checkpoint_000002.nc", "checkpoint_000002.nc.sha256",
                                             "checkpoint_000003.nc", "checkpoint_000003.nc.sha256"}));
  const auto found = checkpoints.newest();
  ASSERT_TRUE(found.checkpoint);
  EXPECT_EQ(found.checkpoint->t, 3.0);
  EXPECT_TRUE(found.damaged.empty());
}

TEST_F(CheckpointFolderTest, ItsSumsAreThoseOfCoreutils) {
  const std::string command = "cd " + folder.path().string() + " && sha256sum --quiet -c *.sha256";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST_F(CheckpointFolderTest, EveryFlippedBitIsFound) {
  const std::string whole = contents(file(3));
  for (std::size_t i = 0; i < whole.size(); i += whole.size() / 50) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
    std::ofstream(file(3), std::ios::binary) << damaged;
    expect_the_second("does not agree with its checksum");
  }
}

TEST_F(CheckpointFolderTest, FallsBackFromWhatIsCutShort) {
  const std::string whole = contents(file(3));
  for (const std::size_t length : {whole.size() - 1, whole.size() / 2, std::size_t{0}}) {
    std::ofstream(file(3), std::ios::binary) << whole.substr(0, length);
    expect_the_second("does not agree with its checksum");
  }
  std::filesystem::remove(file(3).string() + ".sha256");
  expect_the_second("has no checksum beside it");
}

TEST_F(CheckpointFolderTest, SaysWhereNoneIsWhole) {
  for (const int number : {2, 3}) std::ofstream(file(number)) << "rubbish";
  const auto found = checkpoints.newest();
  EXPECT_FALSE(found.checkpoint);
  EXPECT_EQ(found.damaged.size(), 2U);
}

TEST_F(CheckpointFolderTest, ADamagedOneDoesNotCountAmongTheLastTwo) {
  std::ofstream(file(3)) << "rubbish";
  checkpoints.remove_damaged(checkpoints.newest());
  EXPECT_FALSE(std::filesystem::exists(file(3)));
  checkpoints.write(example(4.0));
  EXPECT_TRUE(std::filesystem::exists(file(2)));
  EXPECT_EQ(checkpoints.newest().checkpoint->t, 4.0);
  checkpoints.clear();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(CheckpointFolderTest, AFailedWriteLeavesTheEarlierOnes) {
  std::filesystem::create_directory(file(4));  // in the way
  EXPECT_THROW(checkpoints.write(example(4.0)), core::OutputError);
  EXPECT_EQ(checkpoints.newest().checkpoint->t, 3.0);
  EXPECT_TRUE(std::filesystem::exists(file(2)));
}
}  // namespace
}  // namespace talus::output
