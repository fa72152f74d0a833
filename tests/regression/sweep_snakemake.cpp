#include <gtest/gtest.h>

#include "support/small_sweep.hpp"

/// The Snakefile of a sweep, with the real Snakemake.
namespace {
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::SmallSweep;
namespace fs = std::filesystem;

Outcome snakemake(const SmallSweep& sweep) {
  return outcome_of("/bin/sh", {"-c", "exec snakemake --cores 2 --keep-going --nocolor --snakefile \"$1\"", "sh",
                                (sweep.folder() / "Snakefile").string()});
}

TEST(Snakemake, RunsWhatIsNotFinishedAndTriesFailuresOnceMore) {
  const SmallSweep sweep(talus::support::angles);
  ASSERT_EQ(sweep.sweep({"--write", "snakemake"}).code, 0);
  const auto scene = sweep.folder() / "scenes" / "0001.toml";
  fs::rename(scene, sweep.folder() / "aside");

  const Outcome failed = snakemake(sweep);
  EXPECT_EQ(failed.code, 1);
  const auto first = failed.output.find("0001.toml: cannot be read");
  ASSERT_NE(first, std::string::npos) << failed.output;
  EXPECT_NE(failed.output.find("0001.toml: cannot be read", first + 1), std::string::npos) << failed.output;
  EXPECT_TRUE(sweep.finished(0));
  EXPECT_TRUE(sweep.finished(2));

  fs::rename(sweep.folder() / "aside", scene);
  const auto before = fs::last_write_time(sweep.folder() / "members/0000/summary.json");
  const Outcome rest = snakemake(sweep);
  EXPECT_EQ(rest.code, 0) << rest.output;
  EXPECT_TRUE(sweep.finished(1));
  EXPECT_EQ(fs::last_write_time(sweep.folder() / "members/0000/summary.json"), before);
  EXPECT_NE(snakemake(sweep).output.find("Nothing to be done"), std::string::npos);
  EXPECT_FALSE(fs::exists(sweep.folder() / "x"));
}
}  // namespace
