#include "steady/regularised_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "steady/uniform_flow.hpp"

/// The regularised steady layer against exact solutions, against an independent time-dependent code, and under
/// refinement.
namespace {
using namespace talus;
using steady::RegularisedLayer;
using steady::RegularisedProfile;

constexpr double degree = std::numbers::pi / 180.0;
const rheology::Classical base = rheology::classical(0.4, 0.9, 1.3);
const steady::Channel table_2{rheology::grains(2500.0, 0.6, 0.00073),
                              rheology::partially_regularised(base, 1.3, 1.9, 0.05178), 0.003, 0.3727, 9.81};

double off(double value, double reference) { return std::abs(value / reference - 1.0); }

/// Observed order between the coarsest and the finest of a list of errors under halving.
double order(const std::vector<double>& errors) {
  return std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
}

TEST(RegularisedProfile, ConvergesAtSecondOrder) {
  const RegularisedLayer smooth{{table_2.grains, base, 0.003, 0.3727, 9.81}, {}, 1e-3, 0.012},
      creeping{table_2, {}, 1e-3, 0.012};
  for (const auto& [layer, zeta] : {std::pair{smooth, 38.0}, std::pair{creeping, 45.0}}) {
    const auto finest = RegularisedProfile::at(layer, zeta * degree, 16000);
    std::vector<double> flux, speed;
    for (const int cells : {125, 250, 500, 1000, 2000}) {
      const auto profile = RegularisedProfile::at(layer, zeta * degree, cells);
      flux.push_back(off(profile->flux(), finest->flux()));
      speed.push_back(off(profile->surface_speed(), finest->surface_speed()));
    }
    EXPECT_NEAR(order(flux), 2.0, 0.15) << zeta;
    EXPECT_NEAR(order(speed), 2.0, 0.15) << zeta;
    EXPECT_LT(flux.back(), 2e-6);
    EXPECT_LT(speed.back(), 2e-6);
  }
}

TEST(RegularisedProfile, TendsToTheExactFlowAsWallFrictionSharpens) {
  const auto exact = steady::UniformFlow::at(table_2, 45.0 * degree);
  // Steady surface speeds of an independent method-of-lines code in 400 cells (order 1.4, error 1e-5 m/s), layer of 12
  // mm.
  const std::vector<std::pair<double, double>> other{{1e-3, 0.239448}, {1e-4, 0.238471}, {1e-5, 0.238374}};
  for (const auto& [u_c, surface_speed] : other) {
    const auto profile = RegularisedProfile::at({table_2, {}, u_c, 0.012}, 45.0 * degree, 8000);
    EXPECT_NEAR(profile->surface_speed(), surface_speed, 1.5e-5) << u_c;
    // The shift of the surface speed is u_c times a number near one.
    EXPECT_NEAR((profile->surface_speed() - exact->surface_speed()) / u_c, 1.1, 0.1) << u_c;
  }
  const auto sharp = RegularisedProfile::at({table_2, {}, 1e-7, 0.012}, 45.0 * degree, 8000);
  for (const double z : {0.0, -0.0003, -0.001, -0.0025, -0.004})
    EXPECT_LT(off(sharp->speed(z), exact->speed(z)), 1e-5) << z;
  EXPECT_LT(off(sharp->flux(), exact->flux()), 1e-5);
}

TEST(RegularisedProfile, WithoutWallsIsBagnoldsFlow) {
  const steady::Channel open{table_2.grains, table_2.law, 0.003, 0.0, 9.81};
  const auto exact = steady::UniformFlow::at(open, 26.0 * degree, 0.01);
  const auto profile = RegularisedProfile::at({open, {}, 1e-3, 0.01}, 26.0 * degree);
  for (const double z : {0.0, -0.0031, -0.009}) EXPECT_LT(off(profile->speed(z), exact->speed(z)), 3e-6) << z;
  EXPECT_LT(off(profile->flux(), exact->flux()), 3e-6);
}

TEST(RegularisedProfile, FullyCappedIsANewtonianFilm) {
  const steady::Channel open{table_2.grains, table_2.law, 0.003, 0.0, 9.81};
  const double eta = 1e-3, H = 0.01, zeta = 0.5;
  const RegularisedLayer film{open, {.eta_max = eta, .cap = rheology::Cap::hard}, 1e-3, H};
  const auto profile = RegularisedProfile::at(film, zeta);
  const double weight = open.grains.rho() * open.gravity * std::sin(zeta);
  for (const double z : {0.0, -0.002, -0.007})
    EXPECT_LT(off(profile->speed(z), weight * (H * H - z * z) / (2.0 * eta)), 3e-6) << z;
  EXPECT_LT(off(profile->flux(), open.grains.rho() * open.gap * weight * H * H * H / (3.0 * eta)), 3e-6);
}

TEST(RegularisedProfile, IsFoundFromRestOverTheWholeRangeOfScales) {
  for (const double H : {0.02, 0.1, 0.2})
    for (const double zeta : {30.0, 44.0, 50.0, 65.0}) {
      double last = steady::UniformFlow::at(table_2, zeta * degree, H)->flux();
      for (const double u_c : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
        const auto profile = RegularisedProfile::at({table_2, {}, u_c, H}, zeta * degree, 1000);
        ASSERT_TRUE(profile) << profile.reason() << H << " " << zeta << " " << u_c;
        EXPECT_LT(profile->iterations(), 30) << H << " " << zeta << " " << u_c;
        EXPECT_GT(profile->flux(), last * (1.0 - 3e-6)) << H << " " << zeta << " " << u_c;
        last = profile->flux();
      }
    }
}

TEST(RegularisedProfile, SlopeOfFluxApproachesTheExactSlopeFromBelow) {
  for (const auto& [Q, exact] : {std::pair{0.0020, 44.0963873575666}, std::pair{0.0046, 48.8125930897339},
                                 std::pair{0.0060, 50.4151895425335}}) {
    const auto sharp = steady::slope_of_flux({table_2, {}, 1e-6, 0.1}, Q);
    ASSERT_TRUE(sharp) << sharp.reason();
    EXPECT_NEAR(*sharp / degree, exact, 3e-4);
    double last = exact;
    for (const double u_c : {1e-5, 1e-4, 1e-3, 1e-2}) {
      const RegularisedLayer layer{table_2, {}, u_c, 0.1};
      const auto zeta = steady::slope_of_flux(layer, Q);
      ASSERT_TRUE(zeta) << zeta.reason();
      EXPECT_LT(*zeta / degree, last);
      EXPECT_LT(off(RegularisedProfile::at(layer, *zeta)->flux(), Q), 1e-7);
      last = *zeta / degree;
    }
  }
}
}  // namespace
