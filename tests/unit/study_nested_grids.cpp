#include "study/nested_grids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using talus::study::difference;
using talus::study::GridValues;

/// x + 10 z^2 in the middles of the cells of a unit square.
std::vector<double> field(std::size_t layers, std::size_t columns) {
  std::vector<double> values;
  for (std::size_t k = 0; k < layers; ++k) {
    for (std::size_t i = 0; i < columns; ++i) {
      const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(columns);
      const double z = (static_cast<double>(k) + 0.5) / static_cast<double>(layers);
      values.push_back(x + 10.0 * z * z);
    }
  }
  return values;
}

TEST(NestedGrids, LinearFieldsAgreeAndSquaresDifferByTheCurvature) {
  const auto coarse = field(4, 3), fine = field(8, 6), finer_in_x = field(4, 9);
  const auto norms = difference({4, 3, coarse}, {8, 6, fine});
  const double expected = 10.0 * std::pow(1.0 / 16.0, 2);  // the mean of z^2 a quarter of a cell away
  EXPECT_NEAR(norms.L1, expected, 1e-14);
  EXPECT_NEAR(norms.L2, expected, 1e-14);
  EXPECT_NEAR(norms.Linf, expected, 1e-14);
  EXPECT_NEAR(difference({4, 3, coarse}, {4, 9, finer_in_x}).Linf, 0.0, 1e-14);
}

TEST(NestedGrids, NormsAreMeans) {
  const std::vector<double> coarse{0.0, 0.0}, fine{3.0, 3.0, -1.0, -1.0};
  const auto norms = difference({1, 2, coarse}, {1, 4, fine});
  EXPECT_DOUBLE_EQ(norms.L1, 2.0);
  EXPECT_DOUBLE_EQ(norms.L2, std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(norms.Linf, 3.0);
}

TEST(NestedGrids, CellsWithoutAValueAreLeftOut) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> coarse{none, 1.0}, fine{1.0, 1.0, 3.0, 3.0}, nothing{none, none};
  EXPECT_DOUBLE_EQ(difference({1, 2, coarse}, {1, 4, fine}).L1, 2.0);
  EXPECT_TRUE(std::isnan(difference({1, 2, nothing}, {1, 4, fine}).L2));
}

TEST(NestedGrids, OthersAreRefused) {
  const std::vector<double> two{1.0, 2.0}, three{1.0, 2.0, 3.0};
  EXPECT_THROW((void)difference({1, 2, two}, {1, 3, three}), std::invalid_argument);
  EXPECT_THROW((void)difference({2, 2, two}, {2, 2, two}), std::invalid_argument);
}

}  // namespace
