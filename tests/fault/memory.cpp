#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "support/small_runs.hpp"

/// A run and the machine's memory.
namespace {
using namespace talus::support;

double resident_megabytes(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/statm");
  double all = 0.0, resident = 0.0;
  in >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

TEST(Memory, ARunThatCannotFitIsRefusedBeforeAnyWork) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const Words heap{"run", heap_scene, "--out", out.string()};
  const Outcome limited = outcome_of(TALUS_PROGRAM, heap, {.address_space = 400'000'000});
  EXPECT_EQ(limited.code, 8);
  EXPECT_TRUE(says(limited,
                   "needs about 441 MB of memory, the limit on the address space (ulimit -v) is 400 MB: take a "
                   "coarser grid or more memory"))
      << limited.output;
  const Outcome huge = run_talus(with_settings(heap, {"grid.columns=20000", "grid.layers=2000"}));
  EXPECT_EQ(huge.code, 8);
  EXPECT_TRUE(says(huge, "needs about 400000 MB of memory")) << huge.output;
  EXPECT_FALSE(std::filesystem::exists(out)) << "an earlier run there would be lost";
}

/// More than the estimate, less than libraries, work spaces and factors take of the address space: at the start, in BLAS, in
/// UMFPACK, in KLU.
TEST(Memory, ThatGivesOutOnTheWayEndsTheRun) {
  struct Case {
    std::string columns, layers, solver;
    rlim_t megabytes;
  };
  for (const auto& [columns, layers, solver, megabytes] :
       {Case{"60", "16", "automatic", 150}, Case{"60", "16", "automatic", 220}, Case{"150", "32", "umfpack", 360},
        Case{"150", "32", "klu", 360}}) {
    const TemporaryFolder folder;
    const auto out = folder / "out";
    const Words words =
        with_settings({"run", heap_scene, "--out", out.string()},
                      {"grid.columns=" + columns, "grid.layers=" + layers, "integrator.linear_solver=" + solver,
                       "time.end=0.01", "output.times=[]", "output.series_interval=0.01"});
    Program program(TALUS_PROGRAM, words, {.address_space = megabytes * 1'000'000});
    ASSERT_TRUE(wait_until([&] { return !program.running(); })) << solver << " with " << megabytes << " MB hangs";
    EXPECT_EQ(program.wait(), 8) << program.output();
    const std::string reason = "out of memory: take a coarser grid, or give the run more memory";
    EXPECT_NE(program.output().find(reason), std::string::npos) << program.output();
    if (std::filesystem::exists(out)) { EXPECT_EQ(summary_in(out)["reason"], reason); }
  }
}

TEST(Memory, StaysFlatOverTenThousandSteps) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  Program program(TALUS_PROGRAM,
                  with_settings({"run", chute_scene, "--out", out.string()},
                                {"time.end=0.12", "integrator.max_step=1e-5", "output.series_interval=5e-4",
                                 "output.times=[]", "output.interval=5e-3", "checkpoint.interval=5e-3"}));
  ASSERT_TRUE(wait_for_log(out, "t = 0.01 s")) << program.output();  // 1000 steps
  const double early = resident_megabytes(program.id());
  ASSERT_TRUE(wait_until(
      [&] { return contents(out / "run.log").find("t = 0.1195 s") != std::string::npos || !program.running(); }));
  const double late = resident_megabytes(program.id());
  ASSERT_EQ(program.wait(), 0) << program.output();
  ASSERT_GT(summary_in(out)["statistics"]["steps"], 10000);
  RecordProperty("early", std::to_string(early));
  RecordProperty("late", std::to_string(late));
  EXPECT_GT(early, 10.0);
  EXPECT_LT(late - early, 1.0) << "from " << early << " to " << late << " MB";
}
}  // namespace
