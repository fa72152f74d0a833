#include <gtest/gtest.h>

#include <string>

#include "support/program.hpp"
#include "sweep/engines.hpp"

namespace {
using namespace talus::sweep;

const std::string awkward = "a 'quoted' \"path\" $(touch x) `id` \\ {} %s \xc3\xa9;&";

TEST(ShellQuoted, IsOneWordForAShellWhateverItHolds) {
  for (const std::string& text :
       {awkward, std::string(), std::string("plain"), std::string("'"), std::string("a\nb")}) {
    const auto said = talus::support::outcome_of("/bin/sh", {"-c", "printf %s " + shell_quoted(text)});
    EXPECT_EQ(said.code, 0);
    EXPECT_EQ(said.output, text);
  }
}

Script script(Engine engine, std::size_t n = 500) { return script_for(engine, {"s", n, awkward, "/data/" + awkward}); }

TEST(EngineScripts, HoldPathsOnlyAsLiterals) {
  EXPECT_NE(script(Engine::gnu_parallel).text.find("TALUS=${TALUS:-" + shell_quoted(awkward) + "}\n"),
            std::string::npos);
  EXPECT_NE(script(Engine::slurm).text.find("cd -- " + shell_quoted("/data/" + awkward) + " ||"), std::string::npos);
  EXPECT_NE(script(Engine::slurm).start.find("sbatch '/data/"), std::string::npos);
  const std::string rule = script(Engine::snakemake).text;
  EXPECT_NE(rule.find("os.fsdecode(b'a \\x27quoted\\x27 \\x22path\\x22 \\x24\\x28touch x\\x29"), std::string::npos)
      << rule;
  EXPECT_NE(rule.find("\\x7b\\x7d \\x25s \\xc3\\xa9\\x3b\\x26'))"), std::string::npos) << rule;
}

TEST(EngineScripts, CoverEveryMember) {
  EXPECT_NE(script(Engine::gnu_parallel).text.find("seq 0 499 |"), std::string::npos);
  EXPECT_NE(script(Engine::snakemake).text.find("range(500)"), std::string::npos);
  const std::string array = script(Engine::slurm).text;
  EXPECT_NE(array.find("#SBATCH --array=0-499\n"), std::string::npos);
  EXPECT_NE(array.find("member < 500; member += 500"), std::string::npos);
}

TEST(EngineScripts, ShareMoreMembersThanSlurmTakesAmongItsTasks) {
  const std::string array = script(Engine::slurm, 2500).text;
  EXPECT_NE(array.find("#SBATCH --array=0-999\n"), std::string::npos);
  EXPECT_NE(array.find("member < 2500; member += 1000"), std::string::npos);
}
}  // namespace
