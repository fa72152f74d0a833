#include "rheology/neutral_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rheology/well_posedness.hpp"
#include "support/extreme_laws.hpp"

/// Neutral points and ranges where a scan would miss them: pairs that nearly touch, roots far out, extreme laws.
namespace {
using namespace talus;
using rheology::classical;
using rheology::Law;

double C(const Law& law, double I) { return rheology::condition_C(rheology::response(law, I)); }

/// The mu_d at which the two neutral points of the classical law are `gap` apart, in ratio: found by halving between a
/// law without any and one with a wide pair.
rheology::Classical with_gap(double mu_s, double gap) {
  double none = mu_s * 1.01, wide = mu_s * 5.0;
  for (int i = 0; i < 60; ++i) {
    const double mu_d = 0.5 * (none + wide);
    const auto points = rheology::neutral_points(classical(mu_s, mu_d, 0.3));
    if (points.empty() || points[1] / points[0] - 1.0 < gap) none = mu_d;
    else wide = mu_d;
  }
  return classical(mu_s, wide, 0.3);
}

TEST(ExtremeNeutralPoints, PairsAMillionthApartAreFound) {
  for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const auto law = with_gap(0.38, gap);
    const auto points = rheology::neutral_points(law);
    ASSERT_EQ(points.size(), 2U) << gap;
    EXPECT_NEAR(points[1] / points[0] - 1.0, gap, 0.01 * gap);
    if (gap < 1e-5) continue;  // C between the two is then below its own rounding
    EXPECT_LT(C(law, std::sqrt(points[0] * points[1])), 0.0) << gap;
    EXPECT_GT(C(law, points[0] * (1.0 - gap)), 0.0) << gap;
    EXPECT_GT(C(law, points[1] * (1.0 + gap)), 0.0) << gap;
    const auto ranges = rheology::ranges_of_damping(law);
    ASSERT_EQ(ranges.size(), 1U);
    EXPECT_EQ(ranges[0].from, points[0]);
    EXPECT_EQ(ranges[0].to, points[1]);
  }
}

TEST(ExtremeNeutralPoints, RootsFollowTheScaleOfIToTheEnds) {
  const auto reference = rheology::neutral_points(classical(0.4, 0.9, 1.0));
  for (const double I_0 : {1e-100, 1e-20, 1e20, 1e100}) {
    const auto points = rheology::neutral_points(classical(0.4, 0.9, I_0));
    ASSERT_EQ(points.size(), 2U);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(points[i] / I_0 / reference[i], 1.0, 1e-14);
  }
  // Far out q = mu_d + mu_inf I/2.
  for (const double mu_inf : {1e-90, 1e-40, 1e-12}) {
    const auto law = rheology::partially_regularised(classical(1e-3, 2e-3, 1e-6), mu_inf, 1e-6, 1e-8);
    const auto bounds = rheology::ellipticity_bounds(law);
    ASSERT_EQ(bounds.size(), 1U) << mu_inf;
    EXPECT_NEAR(bounds[0] * mu_inf / 2.0, 1.0 - 2e-3, 1e-12) << mu_inf;
  }
}

/// On each side of every reported point the law is what the ranges say, and nothing changes in between: looked at on a
/// grid of a thousandth, at 600 laws of any shape.
TEST(ExtremeNeutralPoints, RangesHoldAtEveryI) {
  support::LogUniform random(7);
  int changes = 0;
  for (int i = 0; i < 600; ++i) {
    const double decades = i % 3;
    const Law law = i % 4 == 0 ? Law(classical(random(0.05, 1.0), random(1.0, 20.0), random(1e-3, 1e3)))
                               : Law(support::random_partial(random, decades));
    const auto by_C = rheology::ranges_of_condition(law), by_growth = rheology::ranges_of_damping(law);
    const auto within = [](const std::vector<rheology::Range>& ranges, double I) {
      for (const auto& range : ranges)
        if (I >= range.from && I <= range.to) return true;
      return false;
    };
    for (double I = 1e-8; I < 1e8; I *= 1.01) {
      const auto r = rheology::response(law, I);
      const double size = r.q * r.q + 4.0 * r.nu * (1.0 + r.nu);
      if (std::abs(rheology::condition_C(r)) > 1e-13 * size) {
        EXPECT_EQ(within(by_C, I), rheology::condition_C(r) <= 0.0) << i << " I " << I;
      }
      if (std::abs(rheology::max_growth(r)) > 1e-13 && std::abs(std::abs(r.q) - 1.0) > 1e-13) {
        EXPECT_EQ(within(by_growth, I), rheology::max_growth(r) <= 0.0) << i << " I " << I;
      }
    }
    changes += static_cast<int>(rheology::neutral_points(law).size());
  }
  EXPECT_GT(changes, 300);
}

TEST(ExtremeNeutralPoints, EachIsARootOfItsBranch) {
  support::LogUniform random(11);
  int roots = 0;
  for (int i = 0; i < 200; ++i) {
    const auto law = support::random_partial(random, i % 3);
    for (const auto& point : rheology::branch_neutral_points(law)) {
      // The branch without the other one: creep pushed out beyond the point, or away below it.
      auto alone = law;
      if (point.branch == rheology::Branch::rational) alone.I_N = std::min(law.I_N, 0.5 * point.I);
      else if (!point.relevant) continue;
      const double below = C(alone, point.I * (1.0 - 1e-9)), above = C(alone, point.I * (1.0 + 1e-9));
      EXPECT_NE(std::signbit(below), std::signbit(above)) << i << " I " << point.I << " " << below << " " << above;
      ++roots;
    }
  }
  EXPECT_GT(roots, 200);
}

TEST(ExtremeNeutralPoints, CreepIsIllPosedAtRestExactlyWhereAlphaExceedsTwo) {
  for (const double alpha : {0.5, 1.9, 1.999, 2.001, 2.5, 10.0}) {
    const auto law = rheology::partially_regularised(classical(0.4, 0.9, 1.3), 1.3, alpha, 0.05);
    const auto ranges = rheology::ranges_of_damping(law);
    ASSERT_FALSE(ranges.empty());
    EXPECT_EQ(ranges[0].from == 0.0, alpha < 2.0) << alpha;
    EXPECT_EQ(C(law, 1e-190) <= 0.0, alpha < 2.0) << alpha;
  }
}
}  // namespace
