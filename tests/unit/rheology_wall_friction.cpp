#include <gtest/gtest.h>

#include <cmath>

#include "core/dual.hpp"
#include "rheology/wall_friction.hpp"

namespace {

using namespace talus;

double weight(double K) { return rheology::weight_behind(K); }

/// Grains that rub against walls: between two places their pressure falls by a factor e^K, with any K.
TEST(WallFriction, TheWeightedPressureFallsAsJanssenSays) {
  for (const double K : {-30.0, -3.0, -0.5, -0.021, -0.019, -1e-5, 1e-5, 0.019, 0.021, 0.5, 3.0, 30.0}) {
    const double w = weight(K), ahead = 7.0, behind = ahead * (1.0 + K * (1.0 - w)) / (1.0 - K * w);
    EXPECT_NEAR(behind / (ahead * std::exp(K)), 1.0, 1e-9 + 1e-15 * std::exp(std::abs(K))) << K;
  }
}

/// One half without drag, the other way round for motion the other way, never so much that no pressure behind could bear the drag.
TEST(WallFriction, TheWeightLeavesEitherSideItsPart) {
  EXPECT_EQ(weight(0.0), 0.5);
  for (const double K : {1e-6, 0.01, 0.02, 0.1, 1.0, 2.0, 10.0, 36.0}) {
    EXPECT_NEAR(weight(K) + weight(-K), 1.0, 1e-15);
    EXPECT_LT(K * weight(K), 1.0) << K;
    EXPECT_LT(weight(K), 0.5);
  }
  for (const double K : {700.0, 1e5, 1e300}) EXPECT_NEAR(K * weight(K), 1.0, 1e-12) << K;
}

TEST(WallFriction, TheWeightHasNoJumps) {
  const auto at = [](double K) { return rheology::weight_behind(core::Dual<1>::input(K, 0)); };
  for (const double K : {-0.02, 0.0, 0.02}) {
    const auto below = at(K - 1e-12), above = at(K + 1e-12);
    EXPECT_NEAR(below.value, above.value, 1e-12);
    EXPECT_NEAR(below.slope[0], above.slope[0], 1e-9);
    EXPECT_NEAR(above.slope[0], -1.0 / 12.0, 1e-5);
  }
}

}  // namespace
