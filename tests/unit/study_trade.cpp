#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "study/trade.hpp"

namespace {
using namespace talus::study;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(StudyTrade, TheFrontHoldsWhatNothingBeats) {
  // 1 is dearer and worse than 0; 3 costs as much as 2 and is worse; 4 failed; 5 is dear and good
  const std::vector<Priced> choices{{1.0, 0.1},  {2.0, 0.2},   {3.0, 0.05}, {3.0, 0.07},
                                    {0.1, none}, {9.0, 0.001}, {none, 0.0}};
  EXPECT_EQ(pareto_front(choices), (std::vector<std::size_t>{0, 2, 5}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(StudyTrade, OfEqualsTheFirstStands) {
  const std::vector<Priced> choices{{1.0, 0.1}, {1.0, 0.1}};
  EXPECT_EQ(pareto_front(choices), (std::vector<std::size_t>{0}));
}

TEST(StudyTrade, TheCheapestWithinAnError) {
  const std::vector<Priced> choices{{5.0, 0.001}, {2.0, 0.01}, {3.0, 0.009}, {1.0, none}};
  EXPECT_EQ(cheapest_within(choices, 0.01), 1U);
  EXPECT_EQ(cheapest_within(choices, 0.0099), 2U);
  EXPECT_EQ(cheapest_within(choices, 0.0001), std::nullopt);
}

TEST(StudyTrade, GrowthExponentOfAPowerLaw) {
  const std::vector<double> sizes{10.0, 40.0, 90.0};
  std::vector<double> costs;
  for (const double s : sizes) costs.push_back(3.0 * std::pow(s, 1.25));
  EXPECT_NEAR(growth_exponent(sizes, costs).value(), 1.25, 1e-12);
  const std::vector<double> same{7.0, 7.0, 7.0};
  EXPECT_EQ(growth_exponent(same, costs), std::nullopt);
  EXPECT_EQ(growth_exponent(std::span(sizes).first(1), std::span(costs).first(1)), std::nullopt);
}
}  // namespace
