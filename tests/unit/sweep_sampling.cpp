#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sweep/sampling.hpp"
#include "sweep/spacing.hpp"

namespace {
using namespace talus::sweep;

/// Which of the n equal parts of [0, 1) each point of an axis lies in, sorted.
std::vector<std::size_t> parts(const std::vector<double>& axis) {
  std::vector<std::size_t> parts;
  for (const double share : axis) {
    EXPECT_GE(share, 0.0);
    EXPECT_LT(share, 1.0);
    parts.push_back(static_cast<std::size_t>(share * static_cast<double>(axis.size())));
  }
  std::ranges::sort(parts);
  return parts;
}

TEST(LatinHypercube, HasOnePointInEachPartOfEachAxis) {
  for (const std::size_t n : {1U, 2U, 7U, 500U}) {
    const auto points = latin_hypercube(4, n, 11);
    ASSERT_EQ(points.size(), 4U);
    for (const auto& axis : points) {
      const auto in = parts(axis);
      ASSERT_EQ(in.size(), n);
      for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(in[i], i);
    }
  }
}

TEST(LatinHypercube, ShufflesEachAxisOnItsOwn) {
  const auto points = latin_hypercube(2, 200, 5);
  EXPECT_FALSE(std::ranges::is_sorted(points[0]));
  double product = 0.0;
  for (std::size_t i = 0; i < 200; ++i) product += (points[0][i] - 0.5) * (points[1][i] - 0.5);
  EXPECT_LT(std::abs(product / 200.0 * 12.0), 0.25);  // correlation; its standard deviation is 0.07
}

TEST(Samples, AreUniform) {
  double sum = 0.0, squares = 0.0;
  const auto points = random_points(1, 20000, 3);
  for (const double share : points[0]) {
    sum += share;
    squares += share * share;
  }
  EXPECT_NEAR(sum / 20000.0, 0.5, 0.01);
  EXPECT_NEAR(squares / 20000.0, 1.0 / 3.0, 0.01);
}

// The standard fixes the 10,000th number of std::mt19937_64: 9981545732273789042. Ours are its upper halves.
TEST(Samples, AreTheBitsThatTheStandardFixes) {
  Random random(5489);
  for (int i = 0; i < 9999; ++i) random.share();
  EXPECT_EQ(random.share(), static_cast<double>(9981545732273789042ULL >> 32U) / 4294967296.0);
}

TEST(Samples, OfOneSeedAreTheSameAndOfAnotherDiffer) {
  EXPECT_EQ(random_points(3, 10, 1), random_points(3, 10, 1));
  EXPECT_NE(random_points(3, 10, 1), random_points(3, 10, 2));
  EXPECT_EQ(latin_hypercube(3, 10, 1), latin_hypercube(3, 10, 1));
  EXPECT_NE(latin_hypercube(3, 10, 1), latin_hypercube(3, 10, 2));
}

TEST(Random, BelowFavoursNobody) {
  Random random(8);
  std::vector<int> hits(3, 0);
  for (int i = 0; i < 30000; ++i) ++hits.at(random.below(3));
  for (const int n : hits) EXPECT_NEAR(n, 10000, 400);  // five standard deviations
}

TEST(Spacing, IsEvenInDifferencesOrRatiosAndExactAtItsEnds) {
  EXPECT_EQ(spaced({0.1, 0.5, Spacing::linear}, 5), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_EQ(spaced({1e-3, 10.0, Spacing::logarithmic}, 5), (std::vector<double>{1e-3, 1e-2, 0.1, 1.0, 10.0}));
  EXPECT_EQ(spaced({3.0, -1.0, Spacing::linear}, 3), (std::vector<double>{3.0, 1.0, -1.0}));
  const double from = 0.12345678901234567, to = 0.76543210987654321;
  EXPECT_EQ(spaced({from, to, Spacing::logarithmic}, 4).front(), from);
  EXPECT_EQ(spaced({from, to, Spacing::logarithmic}, 4).back(), to);
}

TEST(Spacing, LogarithmicAgreesWithPowersToTwelveDigits) {
  const Interval interval{2e-4, 7.0, Spacing::logarithmic};
  for (const double share : {0.013, 0.25, 0.5, 0.77, 0.999999}) {
    const double expected = 2e-4 * std::pow(7.0 / 2e-4, share);
    EXPECT_NEAR(interval.at(share), expected, 1e-11 * expected) << share;
  }
}

TEST(Spacing, StaysWithinItsEndsWhereTheyHaveMoreDigits) {
  const double from = 0.1000000000000009, to = from * (1.0 + 1e-14);
  EXPECT_GE(Interval({from, to}).at(0.5), from);
  EXPECT_LE(Interval({from, to}).at(0.5), to);
}
}  // namespace
