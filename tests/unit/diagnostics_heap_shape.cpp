#include "diagnostics/heap_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {
using namespace talus::diagnostics;
constexpr double degree = std::numbers::pi / 180.0;
constexpr double tilt = 29.2 * degree, dx = 0.002, x_apex = 0.11;

/// A triangular heap in the tilted box, faces at `left` and `right` [rad] against the horizontal, over a film.
std::vector<double> triangle(int n, double left, double right, double film) {
  const double up = std::tan(left + tilt), down = std::tan(right - tilt), height = down * (n * dx - x_apex);
  std::vector<double> H;
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5) * dx;
    H.push_back(std::max(film, height - (x < x_apex ? up * (x_apex - x) : down * (x - x_apex))));
  }
  return H;
}

TEST(HeapShape, AngleOfAStraightFaceIsExactAgainstTheHorizontal) {
  const auto H = triangle(250, 22.0 * degree, 48.81 * degree, 5e-4);
  const auto face = right_face({dx, tilt, H});
  ASSERT_TRUE(face.has_value());
  EXPECT_NEAR(face->angle / degree, 48.81, 1e-10);
  EXPECT_LT(face->rms, 1e-14);
  // From 20 % to 80 % of the run between the apex, column 55, and the toe at 10 % of its height.
  EXPECT_GE(face->first, 55 + 0.2 * 0.89 * 195);
  EXPECT_LE(face->last, 55 + 0.8 * 0.91 * 195);
}

TEST(HeapShape, RoundedApexAndDroppingToeDoNotEnterTheAngle) {
  auto H = triangle(250, 22.0 * degree, 48.81 * degree, 5e-4);
  for (int i = 45; i < 75; ++i) H[i] -= 0.01 * std::exp(-std::pow((i - 54.5) / 5.0, 2));
  for (int i = 230; i < 250; ++i) H[i] *= 0.5;
  EXPECT_NEAR(right_face({dx, tilt, H})->angle / degree, 48.81, 0.05);
  const double whole = right_face({dx, tilt, H}, {0.0, 0.0, 1.0})->angle / degree;
  EXPECT_GT(std::abs(whole - 48.81), 0.05);
}

TEST(HeapShape, RmsMeasuresWhatTheLineLeaves) {
  auto H = triangle(250, 22.0 * degree, 48.81 * degree, 5e-4);
  for (std::size_t i = 0; i < H.size(); ++i) H[i] += i % 2 ? 1e-4 : -1e-4;
  EXPECT_NEAR(right_face({dx, tilt, H})->rms, 1e-4, 1e-6);
}

TEST(HeapShape, NoFaceIsNoAngle) {
  const std::vector<double> rising{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  EXPECT_FALSE(right_face({dx, tilt, rising}).has_value());
  const std::vector<double> coarse{1.0, 3.0, 2.0, 1.0, 0.5};
  EXPECT_FALSE(right_face({dx, tilt, coarse}).has_value());
}

TEST(HeapShape, ColumnsNeedNotBeEqual) {
  std::vector<double> x, parabola, face;
  for (int i = 0; i < 60; ++i) x.push_back(0.6 * (std::pow(1.03, i + 0.5) - 1.0) / (std::pow(1.03, 60) - 1.0));
  for (const double at : x) {
    parabola.push_back(0.1 - 3.0 * std::pow(at - 0.0533, 2));
    face.push_back(0.2 - 0.4 * at - (at < 0.0533 ? 0.1 : 0.0));
  }
  const Apex a = apex({0.0, tilt, parabola, x});
  EXPECT_NEAR(a.x, 0.0533, 1e-12);
  EXPECT_NEAR(a.H, 0.1, 1e-12);
  EXPECT_NEAR(right_face({0.0, tilt, face, x})->angle, tilt + std::atan(0.4), 1e-12);
  EXPECT_THROW((void)apex({0.0, tilt, face, std::span(x).first(9)}), std::invalid_argument);
}

TEST(HeapShape, ApexIsTheVertexOfTheParabola) {
  std::vector<double> H;
  for (int i = 0; i < 60; ++i) H.push_back(0.1 - 3.0 * std::pow((i + 0.5) * dx - 0.0533, 2));
  const Apex a = apex({dx, tilt, H});
  EXPECT_NEAR(a.x, 0.0533, 1e-12);
  EXPECT_NEAR(a.H, 0.1, 1e-12);
  EXPECT_EQ(a.column, 26);
  const std::vector<double> falling{3.0, 2.0, 1.0}, level{1.0, 1.0, 1.0};
  EXPECT_DOUBLE_EQ(apex({dx, tilt, falling}).x, 0.5 * dx);
  EXPECT_EQ(apex({dx, tilt, level}).column, 0);
  EXPECT_THROW((void)apex({dx, tilt, std::vector<double>{1.0, std::nan(""), 2.0}}), std::invalid_argument);
  EXPECT_THROW((void)apex({dx, tilt, std::vector<double>{1.0, 2.0}}), std::invalid_argument);
}

TEST(HeapShape, SawtoothSeesTwoColumnWavesAndNotApexOrFilm) {
  auto H = triangle(250, 22.0 * degree, 48.81 * degree, 5e-4);
  const std::vector<double> top_layer(H.size(), 2.5e-4);
  EXPECT_LT(sawtooth({dx, tilt, H}, top_layer).share, 1e-9);
  EXPECT_GT(sawtooth({dx, tilt, H}, top_layer, {0.0, 0.0}).share, 1.0);
  for (int i = 150; i < 160; ++i) H[i] += i % 2 ? 1e-5 : -1e-5;
  const Sawtooth found = sawtooth({dx, tilt, H}, top_layer);
  EXPECT_NEAR(found.share, 4e-5 / 2.5e-4, 1e-9);
  EXPECT_TRUE(found.column > 149 && found.column < 160);
  const std::vector<double> film(10, 1e-3), layer(10, 1e-4);
  EXPECT_EQ(sawtooth({dx, tilt, film}, layer).column, -1);
  EXPECT_THROW((void)sawtooth({dx, tilt, H}, layer), std::invalid_argument);
}
}  // namespace
