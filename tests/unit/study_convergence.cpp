#include "study/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace talus::study;

constexpr double limit = 3.0;

/// limit + c h^p on n grids refined by 2.
std::vector<double> powers(double c, double p, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(limit + c * std::pow(0.5, p * i));
  return values;
}

TEST(Convergence, FindsOrderAndLimitOfAPower) {
  for (const double p : {0.6, 1.0, 1.5, 2.0}) {
    const auto found = convergence(powers(-0.4, p, 4), 2.0, 0.0);
    EXPECT_EQ(found.tendency, Tendency::convergent);
    ASSERT_EQ(found.orders.size(), 2U);
    for (const double order : found.orders) EXPECT_NEAR(order, p, 1e-12);
    EXPECT_NEAR(found.value, limit, 1e-13);
    const double error = 0.4 * std::pow(0.5, 3.0 * p);
    EXPECT_NEAR(found.error, error, 1e-13);
    EXPECT_NEAR(found.uncertainty, 1.25 * error, 1e-13) << "two orders agree";
  }
}

TEST(Convergence, OneOrderAloneIsDoubted) {
  const auto found = convergence(powers(-0.4, 2.0, 3), 2.0, 0.0);
  EXPECT_EQ(found.tendency, Tendency::convergent);
  EXPECT_NEAR(found.uncertainty, 3.0 * 0.4 / 16.0, 1e-13);
}

TEST(Convergence, OrdersThatDisagreeAreDoubted) {
  std::vector<double> values;  // h - 0.6 h^2: coarse grids look slower than they are
  for (int i = 0; i < 4; ++i) {
    const double h = std::pow(0.5, i);
    values.push_back(limit + h - 0.6 * h * h);
  }
  const auto found = convergence(values, 2.0, 0.0);
  EXPECT_GT(std::abs(found.orders[0] - found.orders[1]), 0.3);
  EXPECT_NEAR(found.uncertainty, 3.0 * found.error, 1e-15);
  EXPECT_LT(std::abs(values.back() - limit), found.uncertainty);
}

TEST(Convergence, AHighOrderIsShownButNotBuiltUpon) {
  const auto found = convergence(powers(1.0, 5.0, 4), 2.0, 0.0);
  EXPECT_NEAR(found.orders.back(), 5.0, 1e-9);
  const auto values = powers(1.0, 5.0, 4);
  EXPECT_NEAR(found.error, (values[2] - values[3]) / 3.0, 1e-15) << "extrapolated as if of order 2";
}

TEST(Convergence, NoOrderFromFewerThanThreeLevels) {
  const auto two = convergence(std::vector<double>{1.0, 1.1}, 2.0, 0.0);
  EXPECT_TRUE(two.orders.empty());
  EXPECT_EQ(two.tendency, Tendency::unknown);
  EXPECT_TRUE(std::isnan(two.uncertainty));
  EXPECT_EQ(two.value, 1.1);
  EXPECT_EQ(convergence({}, 2.0, 0.0).tendency, Tendency::unknown);
}

TEST(Convergence, AMissingValueIsNotPassedOver) {
  auto values = powers(1.0, 2.0, 5);
  values[1] = std::numeric_limits<double>::quiet_NaN();
  const auto found = convergence(values, 2.0, 0.0);
  EXPECT_EQ(found.tendency, Tendency::unknown);
  EXPECT_TRUE(std::isnan(found.uncertainty));
}

TEST(Convergence, BadOrdersAreShownAndNamed) {
  const auto divergent = convergence(std::vector<double>{1.0, 1.1, 1.3}, 2.0, 0.0);
  EXPECT_EQ(divergent.tendency, Tendency::divergent);
  EXPECT_NEAR(divergent.orders.back(), -1.0, 1e-12);
  EXPECT_TRUE(std::isnan(divergent.uncertainty));
  EXPECT_EQ(divergent.value, 1.3);

  const auto slow = convergence(std::vector<double>{0.0, 1.0, 1.9}, 2.0, 0.0);
  EXPECT_EQ(slow.tendency, Tendency::slow);
  EXPECT_GT(slow.uncertainty, 3.0 * 0.9);

  const auto swinging = convergence(std::vector<double>{1.0, 1.4, 1.2}, 2.0, 0.0);
  EXPECT_EQ(swinging.tendency, Tendency::oscillating);
  EXPECT_TRUE(std::isnan(swinging.orders.back()));
  EXPECT_NEAR(swinging.uncertainty, 1.2, 1e-12);

  const auto wilder = convergence(std::vector<double>{1.0, 1.2, 0.8}, 2.0, 0.0);
  EXPECT_EQ(wilder.tendency, Tendency::divergent);
}

TEST(Convergence, BelowTheIntegratorsResolutionNothingIsSaidOfOrders) {
  const auto found = convergence(std::vector<double>{1.0, 1.0 + 2e-6, 1.0 + 5e-6}, 2.0, 1e-5);
  EXPECT_EQ(found.tendency, Tendency::settled);
  EXPECT_NEAR(found.uncertainty, 3e-6, 1e-12);
  const auto equal = convergence(std::vector<double>{2.0, 2.0, 2.0}, 2.0, 0.0);
  EXPECT_EQ(equal.tendency, Tendency::settled);
  EXPECT_EQ(equal.uncertainty, 0.0);
}

TEST(Convergence, OfDifferences) {
  const auto found = convergence_of_differences(std::vector<double>{0.16, 0.04, 0.01}, 2.0, 0.0);
  EXPECT_EQ(found.tendency, Tendency::convergent);
  for (const double order : found.orders) EXPECT_NEAR(order, 2.0, 1e-12);
  EXPECT_NEAR(found.error, 0.01 / 3.0, 1e-15);
  EXPECT_EQ(convergence_of_differences(std::vector<double>{0.1}, 2.0, 0.0).tendency, Tendency::unknown);
  EXPECT_EQ(convergence_of_differences(std::vector<double>{0.1, 0.2}, 2.0, 0.0).tendency, Tendency::divergent);
}

TEST(Convergence, RefusesARatioThatDoesNotRefine) {
  EXPECT_THROW((void)convergence(std::vector<double>{1.0, 2.0, 3.0}, 1.0, 0.0), std::invalid_argument);
}

}  // namespace
