#include "rheology/hstop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {
using namespace talus;
using rheology::HstopCurve;
using rheology::HstopPoint;

constexpr double degree = std::numbers::pi / 180.0;
const rheology::Grains beads = rheology::grains(2500.0, 0.6, 0.5e-3);
const HstopCurve curve = rheology::hstop_curve(0.38, 0.64, 0.8e-3);

double off(double value, double reference) { return std::abs(value / reference - 1.0); }

/// Exact points at `n` angles from 21.5 to 31.5 degrees.
std::vector<HstopPoint> exact_points(int n) {
  std::vector<HstopPoint> points;
  for (int i = 0; i < n; ++i) {
    const double zeta = (21.5 + 10.0 * i / (n - 1)) * degree;
    points.push_back({zeta, curve.thickness(zeta)});
  }
  return points;
}

/// Standard normal numbers, the same on every machine.
class Normal {
 public:
  double operator()() {
    const double u = (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53;
    const double v = (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
  }

 private:
  std::mt19937_64 bits_{20251125};
};

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::invalid_argument& error) { return error.what(); }
  return "accepted";
}

TEST(Hstop, CurveIsUndoneByItsInverse) {
  for (const double h : {1e-7, 1e-4, 0.8e-3, 0.01, 1.0})
    EXPECT_LT(off(curve.thickness(std::atan(curve.tan_slope(h))), h), 1e-11 * (1.0 + h / curve.length)) << h;
  EXPECT_EQ(curve.tan_slope(0.0), curve.mu_d);
  EXPECT_TRUE(std::isinf(curve.thickness(20.0 * degree)));
  EXPECT_EQ(curve.thickness(33.0 * degree), 0.0);
}

TEST(Hstop, GivesTheClassicalLawAndComesBack) {
  const auto law = rheology::classical_of(curve, 0.136, beads);
  EXPECT_EQ(law.mu_s, 0.38);
  EXPECT_EQ(law.mu_d, 0.64);
  EXPECT_LT(off(law.I_0, 5.0 * 0.136 / (2.0 * std::sqrt(0.6)) * 0.5e-3 / 0.8e-3), 1e-15);
  const auto back = rheology::hstop_of(law, 0.136, beads);
  EXPECT_LT(off(back.length, 0.8e-3), 1e-15);
  // (A3): the friction of a layer with Froude number Fr is that of its inertial number, (A4).
  const double h = 0.006, Fr = 0.7;
  const double I = Fr / h * 5.0 * beads.d / (2.0 * std::sqrt(beads.Phi));
  EXPECT_LT(off(law.friction(I), curve.tan_slope(0.136 * h / Fr)), 1e-14);
}

TEST(Hstop, FitFindsExactDataAgain) {
  for (const int n : {4, 6, 40}) {
    const auto fit = rheology::fit_hstop(exact_points(n));
    EXPECT_LT(off(fit.curve.mu_s, 0.38), 1e-9) << n;
    EXPECT_LT(off(fit.curve.mu_d, 0.64), 1e-9) << n;
    EXPECT_LT(off(fit.curve.length, 0.8e-3), 1e-8) << n;
    EXPECT_LT(fit.residual, 1e-12);
    EXPECT_EQ(fit.correlation[1][1], 1.0);
  }
}

/// With errors of 0.2 degrees in the angle, over 400 sets of data: estimates scatter about the truth as their standard
/// errors say, 68 % of them within one.
TEST(Hstop, StandardErrorsAreThoseOfTheScatter) {
  constexpr int n_sets = 400;
  Normal noise;
  std::array<double, 3> sum{}, sum_of_squares{};
  std::array<int, 3> within{};
  for (int i = 0; i < n_sets; ++i) {
    auto points = exact_points(40);
    for (auto& point : points) point.zeta += 0.2 * degree * noise();
    const auto fit = rheology::fit_hstop(points);
    const std::array<double, 3> miss{fit.curve.mu_s - 0.38, fit.curve.mu_d - 0.64, fit.curve.length - 0.8e-3};
    for (int j = 0; j < 3; ++j) {
      const double z = miss[j] / fit.error[j];
      sum[j] += z;
      sum_of_squares[j] += z * z;
      if (std::abs(z) < 1.0) ++within[j];
    }
  }
  for (int j = 0; j < 3; ++j) {
    EXPECT_NEAR(sum[j] / n_sets, 0.0, 0.25) << j;
    EXPECT_NEAR(sum_of_squares[j] / n_sets, 1.0, 0.3) << j;
    EXPECT_NEAR(static_cast<double>(within[j]) / n_sets, 0.683, 0.07) << j;
  }
}

TEST(Hstop, FitRefusesDataThatCannotDetermineTheCurve) {
  const auto good = exact_points(6);
  const auto with = [&](const std::function<void(std::vector<HstopPoint>&)>& change) {
    auto points = good;
    change(points);
    return refusal([&] { (void)rheology::fit_hstop(points); });
  };
  const auto expect = [](const std::string& found, const std::string& words) {
    EXPECT_NE(found.find(words), std::string::npos) << found;
  };
  EXPECT_EQ(with([](auto&) {}), "accepted");
  expect(with([](auto& p) { p.resize(3); }), "h_stop data: 3 points; expected at least 4");
  expect(with([](auto& p) {
           for (auto& each : p) each.zeta = 0.45;
         }),
         "1 angle(s); expected at least 3");
  expect(with([](auto& p) {
           for (auto& each : p) each.thickness = 0.002;
         }),
         "1 different thicknesses");
  expect(with([](auto& p) { p[2].zeta = 0.5 * std::numbers::pi; }), "expected angles above 0 and below pi/2");
  expect(with([](auto& p) { p[2].zeta = -0.1; }), "zeta = -0.1 rad");
  expect(with([](auto& p) { p[2].zeta = std::nan(""); }), "expected angles");
  expect(with([](auto& p) { p[1].thickness = 0.0; }), "h_stop = 0 m; expected thicknesses above 0");
  expect(with([](auto& p) { p[1].thickness = std::numeric_limits<double>::infinity(); }), "expected thicknesses");
  expect(with([](auto& p) {
           for (auto& each : p) each.thickness = 1e-6 / each.thickness;
         }),
         "does not fall");
  // Only thick deposits: tan zeta - mu_s is (mu_d - mu_s) L/h there, and the product alone is known.
  const auto spread = [](double noise) {
    return [=](auto& p) {
      int i = 0;
      for (auto& each : p) {
        each.thickness = (1.0 + i) * (noise > 0.0 ? 0.7 : 1e5) * curve.length;
        each.zeta = std::atan(curve.tan_slope(each.thickness)) + noise * (i++ % 2 == 0 ? 1.0 : -1.0);
      }
    };
  };
  expect(with(spread(0.0)), "cannot be told apart");
  expect(with(spread(1e-2)), "h_stop data: L = 0.0003823 is uncertain by 0.0007422, more than itself");
}

TEST(Hstop, BadCurvesAndConstantsAreRefused) {
  EXPECT_NE(refusal([] { (void)rheology::hstop_curve(0.4, 0.4, 1e-3); }).find("mu_d = 0.4 must be above mu_s"),
            std::string::npos);
  EXPECT_NE(refusal([] { (void)rheology::hstop_curve(0.4, 0.6, 0.0); }).find("L = 0 must be"), std::string::npos);
  EXPECT_NE(refusal([] { (void)rheology::classical_of(curve, 0.0, beads); }).find("beta = 0 must be"),
            std::string::npos);
  EXPECT_NE(refusal([] {
              (void)rheology::hstop_of({0.4, 0.4, 1.0}, 0.1, beads);
            }).find("mu_d = 0.4 must be above"),
            std::string::npos);
}
}  // namespace
