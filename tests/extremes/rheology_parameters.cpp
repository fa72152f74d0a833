#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <regex>
#include <string>

#include "rheology/hstop.hpp"
#include "rheology/neutral_points.hpp"
#include "rheology/well_posedness.hpp"
#include "support/extreme_laws.hpp"

/// What laws are admitted, what becomes of them at the ends of that, and what is said to the others.
namespace {
using namespace talus;
using rheology::classical;
using rheology::Law;
using rheology::partially_regularised;

const rheology::Classical base = classical(0.4, 0.9, 1.3);
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::invalid_argument& error) { return error.what(); }
  return "accepted";
}

void expect_starts(const std::string& found, const std::string& words) {
  EXPECT_EQ(found.substr(0, words.size()), words);
}

/// The two numbers of "must be from X to Y" in a refusal.
std::pair<double, double> range_in(const std::string& message) {
  static const std::regex range("from ([0-9.e+-]+) to ([0-9.e+-]+)");
  std::smatch found;
  if (!std::regex_search(message, found, range)) throw std::runtime_error("no range in: " + message);
  return {std::stod(found[1]), std::stod(found[2])};
}

/// A parameter by its name, and a law made with any value of it.
struct Parameter {
  std::string name;
  std::function<void(double)> make;
};

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> list{
      {"classical: mu_s", [](double x) { (void)classical(x, 1e6, 1.0); }},
      {"classical: mu_d", [](double x) { (void)classical(1e-100, x, 1.0); }},
      {"classical: I_0", [](double x) { (void)classical(0.4, 0.9, x); }},
      {"constant: mu_s", [](double x) { (void)rheology::constant(x); }},
      {"partially regularised: mu_inf", [](double x) { (void)partially_regularised(base, x, 1.9, 1e-3); }},
      {"partially regularised: I_N", [](double x) { (void)partially_regularised(base, 0.0, 1.9, x); }},
      {"partially regularised: alpha", [](double x) { (void)partially_regularised(base, 1.3, x, 0.05); }}};
  return list;
}

TEST(ExtremeParameters, ARefusalNamesParameterValueAndRangeAndTheRangeIsTrue) {
  for (const auto& [name, make] : parameters()) {
    for (const double bad : {nan, infinity, -infinity, -1.0, -5e-324, 5e-324, 1e308}) {
      const std::string message = refusal([&] { make(bad); });
      EXPECT_TRUE(message.starts_with(name + " = ")) << name << " " << bad << ": " << message;
    }
    const auto [low, high] = range_in(refusal([&] { make(-1.0); }));
    EXPECT_EQ(refusal([&] { make(low); }), "accepted") << name << " " << low;
    EXPECT_EQ(refusal([&] { make(high); }), "accepted") << name << " " << high;
    EXPECT_NE(refusal([&] { make(std::nextafter(low, 0.0)); }), "accepted") << name << " " << low;
    EXPECT_NE(refusal([&] { make(std::nextafter(high, infinity)); }), "accepted") << name << " " << high;
  }
  EXPECT_EQ(refusal([] { (void)partially_regularised(base, 0.0, 1.9, 1e-3); }), "accepted");
}

TEST(ExtremeParameters, ALawThatWouldFallIsRefusedWithTheReason) {
  EXPECT_EQ(refusal([] { (void)classical(0.4, 0.3, 1.3); }),
            "classical: mu_d = 0.3 must be at least mu_s = 0.4, or friction would fall as I grows");
  expect_starts(refusal([] { (void)classical(0.4, std::nextafter(0.4, 0.0), 1.3); }), "classical: mu_d = 0.39999999");
  expect_starts(refusal([] { (void)partially_regularised({0.4, 0.3, 1.3}, 1.3, 1.9, 0.05); }), "classical: mu_d = 0.3");
  expect_starts(refusal([] { (void)partially_regularised(base, -0.1, 1.9, 0.05); }),
                "partially regularised: mu_inf = -0.1 must be 0, or from");
}

/// Rational friction with mu_d >= mu_s and mu_inf >= 0 cannot fall, creep cannot fall, and they meet: so no admitted
/// set can, which `ExtremeI.FrictionNeverFalls` tries on 300 random sets. What the factory refuses does fall.
TEST(ExtremeParameters, WhatIsRefusedForFallingDoesFall) {
  const rheology::Classical falling{0.4, 0.3, 1.3};
  EXPECT_LT(falling.friction(1.0), falling.friction(0.0));
  EXPECT_LT(rheology::friction_slope(Law(falling), 1.0), 0.0);
  const rheology::PartiallyRegularised turning{0.4, 0.9, -0.1, 1.3, 0.05, 1.9, 0.4, 10.0, 1.0};
  EXPECT_LT(turning.rational(100.0), turning.rational(10.0));
}

TEST(ExtremeParameters, WithoutMuInfThePartialLawSaturatesLikeTheClassicalOne) {
  const auto law = partially_regularised(base, 0.0, 1.9);
  EXPECT_EQ(rheology::friction_bound(law), 0.9);
  for (const double I : {0.06, 1.0, 1e6, 1e300}) EXPECT_EQ(law.friction(I), base.friction(I)) << I;
  try {
    (void)law.inverse(0.9);
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(
        error.what(),
        "partially regularised: no inertial number has the friction mu = 0.9 (with mu_inf = 0 needs mu < mu_d ="
        " 0.9)");
  }
  // Creep removes the lower bound of well-posedness, the upper one stays the classical one.
  const auto ranges = rheology::ranges_of_condition(law);
  ASSERT_EQ(ranges.size(), 1U);
  EXPECT_EQ(ranges[0].from, 0.0);
  EXPECT_NEAR(ranges[0].to, 2.99571172836610, 1e-13);
  EXPECT_TRUE(rheology::ellipticity_bounds(law).empty());
}

TEST(ExtremeParameters, WithMuDEqualToMuSTheClassicalLawIsTheConstantOne) {
  const auto law = classical(0.4, 0.4, 1.3);
  for (const double I : {0.0, 1e-300, 1.0, 1e300}) EXPECT_EQ(law.friction(I), 0.4);
  try {
    (void)law.inverse(0.4);
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(error.what(),
                 "classical: no inertial number has the friction mu = 0.4 (every I has mu_s = mu_d = 0.4)");
  }
  EXPECT_TRUE(rheology::ranges_of_condition(law).empty());
  EXPECT_TRUE(rheology::neutral_points(law).empty());
  EXPECT_NE(refusal([&] { (void)partially_regularised(law, 1.3, 1.9); }).find("I_N must be given"), std::string::npos);
  const auto partial = partially_regularised(law, 1.3, 1.9, 0.05);
  EXPECT_LT(std::abs(partial.inverse(partial.friction(3.0)) / 3.0 - 1.0), 1e-15);
}

TEST(ExtremeParameters, CreepOfTinyAndHugeAlphaIsAStepAndAPlateau) {
  const auto step = partially_regularised(base, 1.3, 2e-51, 0.05),
             plateau = partially_regularised(base, 1.3, 40.0, 0.05);
  EXPECT_EQ(step.A, 0.05);  // it rounds to I_N
  EXPECT_LT(step.friction(0.049), 1e-24);
  EXPECT_EQ(step.friction(0.05), step.mu_N);
  EXPECT_GT(plateau.friction(1e-9), 0.9 * plateau.mu_N);
  EXPECT_GT(plateau.A, 1e90);
}

TEST(ExtremeParameters, GrainsAndDepositsRefuseByNameToo) {
  for (const double bad : {nan, infinity, -1.0, 0.0}) {
    expect_starts(refusal([&] { (void)rheology::grains(bad, 0.6, 1e-3); }), "grains: rho_star = ");
    expect_starts(refusal([&] { (void)rheology::grains(2500.0, bad, 1e-3); }), "grains: Phi = ");
    expect_starts(refusal([&] { (void)rheology::grains(2500.0, 0.6, bad); }), "grains: d = ");
    expect_starts(refusal([&] { (void)rheology::hstop_curve(0.4, 0.6, bad); }), "h_stop: L = ");
    const auto curve = rheology::hstop_curve(0.4, 0.6, 1e-3);
    expect_starts(refusal([&] { (void)rheology::classical_of(curve, bad, rheology::grains(2500.0, 0.6, 1e-3)); }),
                  "h_stop: beta = ");
  }
}
}  // namespace
