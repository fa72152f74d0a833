#include "study/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace talus::study;

GrowthFit rate(double value, double uncertainty = 0.01) { return {value, uncertainty, 0.0, 1.0, 10}; }

TEST(Growth, FitsAnExponentialInItsWindow) {
  std::vector<double> t, a;
  for (int i = 0; i <= 20; ++i) {
    t.push_back(0.1 * i);
    a.push_back(t.back() < 0.95 ? 1.0 : 3e-4 * std::exp(2.5 * t.back()));  // something else before
  }
  const auto fit = fit_growth(t, a, 1.0, 2.0);
  EXPECT_NEAR(fit.rate, 2.5, 1e-12);
  EXPECT_NEAR(fit.uncertainty, 0.0, 1e-12);
  EXPECT_EQ(fit.n, 11U);
  EXPECT_GT(std::abs(fit_growth(t, a, 0.0, 2.0).rate - 2.5), 0.5);
}

TEST(Growth, ACurveThatIsNoExponentialIsUncertain) {
  std::vector<double> t, a;
  for (int i = 1; i <= 40; ++i) {
    t.push_back(0.1 * i);
    a.push_back(std::pow(t.back(), 3));  // local rates 3/t
  }
  const auto fit = fit_growth(t, a, 1.0, 4.0);
  EXPECT_LT(fit.rate - fit.uncertainty, 3.0 / 3.0);
  EXPECT_GT(fit.rate + fit.uncertainty, 3.0 / 2.0);
}

TEST(Growth, TooFewPointsFitNothing) {
  const std::vector<double> t{0.0, 1.0, 2.0, 3.0}, a{1.0, 0.0, 2.0, 4.0};
  EXPECT_TRUE(std::isnan(fit_growth(t, a, 0.0, 3.0).rate)) << "three have an amplitude";
  EXPECT_THROW((void)fit_growth(t, std::vector<double>{1.0}, 0.0, 1.0), std::invalid_argument);
  EXPECT_THROW((void)fit_growth(std::vector<double>{1.0, 0.0}, std::vector<double>{1.0, 1.0}, 0.0, 1.0),
               std::invalid_argument);
}

TEST(Growth, VerdictsOnPlantedRates) {
  const auto blows = growth_verdict(std::vector{rate(-0.3), rate(1.0), rate(4.1), rate(16.2)}, 2.0);
  EXPECT_EQ(blows.tendency, GrowthTendency::blows_up);
  EXPECT_NEAR(blows.exponent, 2.0, 0.05);
  EXPECT_EQ(growth_verdict(std::vector{rate(-1.0), rate(-1.2), rate(-1.3)}, 2.0).tendency, GrowthTendency::decays);
  EXPECT_EQ(growth_verdict(std::vector{rate(0.2), rate(0.5), rate(0.51)}, 2.0).tendency, GrowthTendency::converges);
  EXPECT_EQ(growth_verdict(std::vector{rate(-1.0), rate(2.0), rate(3.0), rate(3.4)}, 2.0).tendency,
            GrowthTendency::converges)
      << "differences fall at order 1.3";
  EXPECT_EQ(growth_verdict(std::vector{rate(5.0), rate(6.0), rate(7.2)}, 2.0).tendency, GrowthTendency::not_convergent)
      << "they rise, but slower than any root of k";
}

TEST(Growth, GridsThatCannotTellSayHowManyMoreMay) {
  const auto finest_alone = growth_verdict(std::vector{rate(-0.5), rate(-0.1), rate(2.0)}, 2.0);
  EXPECT_EQ(finest_alone.tendency, GrowthTendency::cannot_tell);
  EXPECT_EQ(finest_alone.finer, 2) << "three that grow are needed";
  const auto slow = growth_verdict(std::vector{rate(4.0), rate(5.0), rate(5.9)}, 2.0);
  EXPECT_EQ(slow.tendency, GrowthTendency::cannot_tell) << "differences fall, at order 0.15";
  EXPECT_EQ(slow.finer, 1);
  const auto two_grids = growth_verdict(std::vector{rate(1.0), rate(4.0)}, 2.0);
  EXPECT_EQ(two_grids.tendency, GrowthTendency::cannot_tell);
  EXPECT_EQ(two_grids.finer, 1);
}

}  // namespace
