#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "grid/layering.hpp"

namespace {

using talus::grid::Layering;
using talus::grid::Spacing;

struct Heights {
  std::vector<double> z, dz, d2z;
};

Heights at(const Layering& layering, double H) {
  const std::size_t n = layering.n_layers() + 1;
  Heights h{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  layering.heights(H, h.z, h.dz, h.d2z);
  return h;
}

class EachSpacing : public testing::TestWithParam<Spacing> {};

TEST_P(EachSpacing, DerivativesEqualCentralDifferences) {
  const Layering layering(7, 0.003, GetParam());
  for (const double H : {5e-4, 0.01, 0.2}) {
    const double step = 1e-5 * H;
    const auto here = at(layering, H), up = at(layering, H + step), down = at(layering, H - step);
    for (int k = 0; k <= 7; ++k) {
      EXPECT_NEAR(here.dz[k], (up.z[k] - down.z[k]) / (2 * step), 1e-8);
      EXPECT_NEAR(here.d2z[k] * H, (up.dz[k] - down.dz[k]) / (2 * step) * H, 1e-8);
    }
  }
}

TEST_P(EachSpacing, RunsFromTheBaseToTheSurface) {
  const Layering layering(10, 0.003, GetParam());
  for (const double H : {1e-6, 0.15}) {
    const auto h = at(layering, H);
    EXPECT_EQ(h.z[0], 0.0);
    EXPECT_DOUBLE_EQ(h.z[10], H);
    for (int k = 0; k < 10; ++k) EXPECT_GT(h.z[k + 1], h.z[k]);
    EXPECT_NEAR(layering.top_layer(H), h.z[10] - h.z[9], 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Layering, EachSpacing, testing::Values(Spacing::clustered, Spacing::uniform));

TEST(Layering, ClusteredIsUniformWhereThinAndFineAtTheSurfaceOfADeepColumn) {
  const Layering layering(10, 0.003);
  const auto thin = at(layering, 1e-6);
  for (int k = 0; k <= 10; ++k) EXPECT_NEAR(thin.z[k], k * 1e-7, 1e-10);
  EXPECT_LT(layering.top_layer(0.15), 0.1 * 0.15 / 10);
}

TEST(Layering, ClusteredDepthsAreThoseOfTheirFormula) {
  const double H0 = 0.003;
  for (const int n : {4, 32, 1000})
    for (const double H : {1e-7, 0.01, 3.0}) {
      const auto h = at(Layering(n, H0), H);
      for (int k = 1; k <= n; ++k) {
        const double s = 1.0 - static_cast<double>(k) / n;
        EXPECT_NEAR(h.z[k], H - H0 * std::expm1(s * std::log1p(H / H0)), 2e-16 * n * H) << n << ' ' << H << ' ' << k;
      }
    }
}

TEST(Layering, UniformIsUniformAtAnyDepth) {
  const auto h = at(Layering(8, 0.003, Spacing::uniform), 0.2);
  for (int k = 0; k <= 8; ++k) EXPECT_DOUBLE_EQ(h.z[k], 0.025 * k);
}
}  // namespace
