#include <gtest/gtest.h>

#include "support/example_scene.hpp"
#include "support/scene_run.hpp"

/// The inlet as it is opened, throttled, torn open and shut: all that was poured is in the box or has left it.
namespace {

using namespace talus;

class Inlet : public testing::TestWithParam<double> {};

TEST_P(Inlet, OnAndOffEverySecondPoursWhatItsScheduleSays) {
  const double ramp = GetParam();
  const auto scene = tests::small(
      "heap_q46", 24, 8,
      {"inflow.times=[1, 2, 3, 4]", "inflow.shares=[0, 3, 0.1, 0]", "inflow.ramp=" + std::to_string(ramp),
       "output.times=[]", "integrator.rtol=3e-5"});  // at 1e-4 the budget's own tolerance is 2e-3 of the first second
  const std::vector<double> shares{1.0, 0.0, 3.0, 0.1, 0.0};
  tests::SceneRun run(scene);
  const double rate = scene.inflow.rate;
  double poured = 0.0;
  for (int second = 0; second < 5; ++second) {
    run.advance(second + 1.0);
    const double change = shares[second] - (second > 0 ? shares[second - 1] : 0.0);
    poured += rate * (shares[second] - 0.5 * ramp * change);  // the quintic ramp is at one half on average
    EXPECT_NEAR(run.number("mass_inflow"), poured, 1e-3 * poured) << "after " << second + 1 << " s";
    EXPECT_NEAR(run.number("inflow_rate"), rate * shares[second], 1e-12);
    EXPECT_NEAR(run.number("mass_error"), 0.0, 1e-12);
  }
  EXPECT_LE(run.current().statistics.newton_failures, 2);
}

INSTANTIATE_TEST_SUITE_P(Ramps, Inlet, testing::Values(0.2, 1e-3));

}  // namespace
