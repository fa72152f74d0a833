#include "core/polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using talus::core::Polynomial;
using talus::core::positive_roots;

Polynomial with_roots(const std::vector<long double>& roots) {
  Polynomial p{1.0L};
  for (const long double x : roots) p = p * Polynomial{-x, 1.0L};
  return p;
}

void expect_roots(const Polynomial& p, const std::vector<double>& roots, double tolerance) {
  const auto found = positive_roots(p);
  ASSERT_EQ(found.size(), roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(found[i] / roots[i], 1.0, tolerance) << roots[i];
}

TEST(Polynomial, PositiveRootsAreFoundAcrossManyDecades) {
  expect_roots(with_roots({1e-150L, 1e-30L, 1.0L, 1e30L, 1e150L}), {1e-150, 1e-30, 1.0, 1e30, 1e150}, 1e-15);
  expect_roots(with_roots({3.0L, 0.5L, -2.0L}) * Polynomial{1.0L, 0.0L, 1.0L}, {0.5, 3.0}, 1e-15);
}

TEST(Polynomial, PairsFarCloserThanAScanWouldSeeAreKeptApart) {
  for (const long double gap : {1e-2L, 1e-4L, 1e-6L, 1e-8L})
    expect_roots(with_roots({0.01L, 1.0L, 1.0L + gap, 40.0L}), {0.01, 1.0, static_cast<double>(1.0L + gap), 40.0},
                 1e-17 / static_cast<double>(gap) + 1e-15);
}

TEST(Polynomial, WhatOnlyTouchesZeroIsNoRoot) {
  EXPECT_TRUE(positive_roots(with_roots({2.0L, 2.0L})).empty());
  expect_roots(with_roots({2.0L, 2.0L, 2.0L}), {2.0}, 1e-6);  // a triple root is as ill-conditioned as that
  EXPECT_TRUE(positive_roots({1.0L, 0.0L, 3.0L}).empty());
  EXPECT_TRUE(positive_roots({}).empty());
  EXPECT_TRUE(positive_roots({0.0L, 0.0L}).empty());
  EXPECT_TRUE(positive_roots({5.0L}).empty());
  expect_roots({0.0L, -3.0L, 1.0L, 0.0L}, {3.0}, 1e-15);
}

TEST(Polynomial, AProductHasTheValuesOfItsFactors) {
  const Polynomial a{1.0L, -2.0L, 3.0L}, b{0.5L, 4.0L};
  EXPECT_EQ((a * b)(2.0L), a(2.0L) * b(2.0L));
  EXPECT_EQ((b - a)(2.0L), b(2.0L) - a(2.0L));
}
}  // namespace
