#include <gtest/gtest.h>

#include <cmath>

#include "steady/regularised_profile.hpp"
#include "steady/uniform_flow.hpp"

namespace {
using namespace talus;
using steady::RegularisedLayer;
using steady::RegularisedProfile;

const rheology::Classical base = rheology::classical(0.4, 0.9, 1.3);
const steady::Channel table_2{rheology::grains(2500.0, 0.6, 0.00073),
                              rheology::partially_regularised(base, 1.3, 1.9, 0.05178), 0.003, 0.3727, 9.81};
const steady::Channel classical_2{table_2.grains, base, 0.003, 0.3727, 9.81};

TEST(RegularisedProfile, BalancesTheWholeLayer) {
  // Weight along the slope = wall friction + stress on the base, summed from the profile itself.
  const double H = 0.012, zeta = 0.8, u_c = 1e-3, rho_g = 1500.0 * 9.81;
  const rheology::Regularisation reg{0.5, 1e-3, 1e-5, 1e4, rheology::Cap::smooth};
  const auto profile = RegularisedProfile::at({table_2, reg, u_c, H}, zeta, 4000);
  ASSERT_TRUE(profile) << profile.reason();
  const auto z = profile->z(), u = profile->speeds();
  double friction = 0.0;
  for (std::size_t i = 0; i + 1 < z.size(); ++i) {
    const double p = -0.5 * rho_g * std::cos(zeta) * (z[i] + z[i + 1]);
    friction += (z[i] - z[i + 1]) * 2.0 * 0.3727 / 0.003 * rheology::positive_pressure(p, reg.p_0) *
                std::tanh(0.5 * (u[i] + u[i + 1]) / u_c);
  }
  const std::size_t n = z.size() - 1;
  const double rate = u[n - 1] / (z[n - 1] - z[n]), p_base = -0.5 * rho_g * std::cos(zeta) * (z[n - 1] + z[n]);
  const double on_base = rate * rheology::viscosity(table_2.law, table_2.grains, reg, 0.25 * rate * rate,
                                                    std::hypot(1e-3, 1e-5 / H), p_base);
  EXPECT_NEAR((friction + on_base) / (rho_g * std::sin(zeta) * H), 1.0, 1e-3);
  EXPECT_GT(on_base, 0.01 * friction);
}

TEST(RegularisedProfile, InterpolatesBetweenItsNodes) {
  const auto coarse = RegularisedProfile::at({table_2, {}, 1e-3, 0.012}, 0.8, 500);
  const auto z = coarse->z();
  EXPECT_EQ(z.size(), 501U);
  EXPECT_EQ(z.front(), 0.0);
  EXPECT_NEAR(z.back(), -0.012, 1e-15);
  for (const std::size_t i : {0UL, 1UL, 250UL, 500UL}) EXPECT_NEAR(coarse->speed(z[i]), coarse->speeds()[i], 1e-12);
  const auto fine = RegularisedProfile::at({table_2, {}, 1e-3, 0.012}, 0.8, 1000);
  for (const double x : {-1e-5, -0.001, -0.0043, -0.0117}) EXPECT_NEAR(coarse->speed(x), fine->speed(x), 2e-5);
  EXPECT_THROW((void)coarse->speed(-0.013), std::invalid_argument);
  EXPECT_THROW((void)coarse->speed(1e-6), std::invalid_argument);
}

TEST(RegularisedProfile, ComesToRestWhereTheLawIsBelowYield) {
  const auto resting = RegularisedProfile::at({classical_2, {}, 1e-4, 0.05}, 0.3, 500);
  ASSERT_TRUE(resting) << resting.reason();
  EXPECT_LT(resting->surface_speed(), 1e-12);
  EXPECT_GT(resting->surface_speed(), 0.0);
}

TEST(RegularisedProfile, NoSteadyStateIsAnAnswer) {
  const auto steep = RegularisedProfile::at({classical_2, {}, 1e-3, 0.05}, 0.8);
  EXPECT_FALSE(steep);
  EXPECT_NE(steep.reason().find("classical law cannot carry"), std::string::npos) << steep.reason();
  const auto large = steady::slope_of_flux(RegularisedLayer{classical_2, {}, 1e-3, 0.05}, 0.1, 500);
  EXPECT_FALSE(large);
  EXPECT_NE(large.reason().find("no steady slope carries Q = 0.1"), std::string::npos) << large.reason();
  EXPECT_NE(large.reason().find("cannot carry the stress"), std::string::npos) << large.reason();
  EXPECT_FALSE(
      RegularisedProfile::at({{table_2.grains, rheology::constant(0.4), 0.003, 0.3727, 9.81}, {}, 1e-3, 0.05}, 0.5));
}

TEST(RegularisedProfile, BadInputIsRefused) {
  using std::invalid_argument;
  const RegularisedLayer good{table_2, {}, 1e-3, 0.05};
  EXPECT_THROW((void)RegularisedProfile::at({table_2, {}, 0.0, 0.05}, 0.7), invalid_argument);
  EXPECT_THROW((void)RegularisedProfile::at({table_2, {}, 1e-3, steady::unbounded}, 0.7), invalid_argument);
  EXPECT_THROW((void)RegularisedProfile::at({table_2, {-1.0}, 1e-3, 0.05}, 0.7), invalid_argument);
  EXPECT_THROW((void)RegularisedProfile::at(good, 1.7), invalid_argument);
  EXPECT_THROW((void)RegularisedProfile::at(good, 0.7, 3), invalid_argument);
  EXPECT_THROW((void)steady::slope_of_flux(good, -1.0), invalid_argument);
}
}  // namespace
