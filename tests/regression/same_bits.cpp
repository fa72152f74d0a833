#include <gtest/gtest.h>

#include "support/same_run.hpp"
#include "support/small_runs.hpp"

namespace {
using namespace talus::support;

/// Large enough for two threads in residual, Jacobian and band solver. One core makes them take turns; a system that refuses
/// every thread leaves all the work to one.
TEST(SameBits, WithOneThreadOneCoreAndAll) {
  for (const char* solver : {"condensed", "automatic"}) {
    const TemporaryFolder folder;
    const auto run = [&](const char* out, const Limits& limits) {
      const auto words =
          with_settings({"run", heap_scene, "--out", (folder / out).string()},
                        {"grid.columns=60", "grid.layers=16", "time.end=0.3", "inflow.stop=10", "output.times=[]",
                         "output.series_interval=0.01", std::string("integrator.linear_solver=") + solver});
      const Outcome outcome = outcome_of(TALUS_PROGRAM, words, limits);
      EXPECT_EQ(outcome.code, 0) << outcome.output;
    };
    run("all", {});
    run("one_core", {.one_core = true});
    run("one_thread", {.preload = TALUS_NO_THREADS});
    for (const char* other : {"one_core", "one_thread"})
      EXPECT_EQ(differences_between(folder / "all", folder / other), "") << solver << ", " << other;
  }
}
}  // namespace
