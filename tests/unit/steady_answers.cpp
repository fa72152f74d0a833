#include "steady/slope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "steady/quadrature.hpp"

namespace {
using namespace talus;
using steady::Channel;
using steady::UniformFlow;

constexpr double degree = std::numbers::pi / 180.0;
const rheology::Classical base = rheology::classical(0.4, 0.9, 1.3);
const Channel table_2{rheology::grains(2500.0, 0.6, 0.00073), rheology::partially_regularised(base, 1.3, 1.9, 0.05178),
                      0.003, 0.3727, 9.81};
const Channel classical_2{table_2.grains, base, table_2.gap, table_2.mu_w, table_2.gravity};

TEST(Quadrature, IsExactForPolynomialsAndResolvesNearPolesAndSteepDecay) {
  EXPECT_NEAR(steady::gauss_panel([](double x) { return std::pow(x, 38); }, -1.0, 1.0), 2.0 / 39.0, 1e-15);
  const double delta = 1e-4;
  EXPECT_NEAR(
      steady::integral([&](double x) { return delta / (delta * delta + x * x); }, 0.0, 1.0) / std::atan(1.0 / delta),
      1.0, 1e-12);
  EXPECT_NEAR(steady::integral([](double x) { return 500.0 * std::exp(-500.0 * x); }, 0.0, 1.0), 1.0, 1e-13);
  EXPECT_EQ(steady::integral([](double) { return 1.0; }, 1.0, 1.0), 0.0);
}

TEST(Quadrature, GivesUpOnWhatIsNotFiniteOrNotSmooth) {
  const auto code = [](auto&& f) {
    try {
      (void)steady::integral(f, 0.0, 1.0);
    } catch (const core::Error& error) { return error.code(); }
    return core::ExitCode::ok;
  };
  EXPECT_EQ(code([](double x) { return x > 0.3 ? std::nan("") : 1.0; }), core::ExitCode::solver);
  EXPECT_EQ(code([](double x) { return 2.0 + std::sin(1e9 * x); }), core::ExitCode::solver);
}

TEST(UniformFlow, SpeedIsTheIntegralOfItsShearRate) {
  const auto flow = UniformFlow::at(table_2, 45.0 * degree);
  for (const double z : {-0.0005, -0.003, -0.005}) {
    const double h = 1e-7;
    const double shear = (flow->speed(z + h) - flow->speed(z - h)) / (2.0 * h);
    EXPECT_NEAR(
        shear * table_2.grains.d / std::sqrt(-0.6 * 9.81 * z * std::cos(45.0 * degree)) / flow->inertial_number(z), 1.0,
        1e-6);
  }
  EXPECT_EQ(flow->speed(-0.1), 0.0);
  EXPECT_EQ(flow->inertial_number(-0.1), 0.0);
}

TEST(UniformFlow, PartsOfTheFluxAddUpAndSharesOfTheSpeedAreFound) {
  const auto flow = UniformFlow::at(table_2, 48.8126 * degree);
  EXPECT_NEAR(flow->flux_above(1.0) / flow->flux(), 1.0, 1e-14);
  const double a = 0.002, b = 0.0021;
  const double between = steady::integral([&](double s) { return flow->speed(-s); }, a, b) * 4.5;
  EXPECT_NEAR((flow->flux_above(b) - flow->flux_above(a)) / between, 1.0, 1e-9);
  for (const double share : {0.9, 0.5, 0.01})
    EXPECT_NEAR(flow->speed(-flow->depth_at_share(share)) / flow->surface_speed(), share, 1e-10);
  // DESIGN's measure of the layer: 2.7 mm at half the speed, 5.6 mm at one percent.
  EXPECT_NEAR(flow->depth_at_share(0.5), 2.7e-3, 0.1e-3);
  EXPECT_NEAR(flow->depth_at_share(0.01), 5.6e-3, 0.1e-3);
  EXPECT_THROW((void)flow->depth_at_share(1.0), std::invalid_argument);
  EXPECT_THROW((void)flow->speed(0.001), std::invalid_argument);
  const double h = 0.004;
  EXPECT_NEAR(flow->froude(h), flow->flux_above(h) / (4.5 * h * std::sqrt(9.81 * h * std::cos(flow->zeta()))), 1e-12);
}

TEST(UniformFlow, ABaseCutsTheProfileByItsSpeedThere) {
  const auto heap = UniformFlow::at(table_2, 45.0 * degree), layer = UniformFlow::at(table_2, 45.0 * degree, 0.003);
  for (const double z : {0.0, -0.001, -0.0029})
    EXPECT_NEAR(layer->speed(z), heap->speed(z) - heap->speed(-0.003), 1e-14);
  EXPECT_EQ(layer->depth(), 0.003);
  EXPECT_EQ(heap->depth(), -heap->z_st());
}

TEST(UniformFlow, NoSteadyStateIsAnAnswerWithItsReason) {
  const auto steep = UniformFlow::at(classical_2, 45.0 * degree);
  EXPECT_FALSE(steep);
  EXPECT_NE(steep.reason().find("is not below 0.9 (41.9872 degrees), the largest friction of the classical law; steady "
                                "flow reaches up to Q_max = 0.00459326"),
            std::string::npos)
      << steep.reason();
  const auto flat = UniformFlow::at(classical_2, 20.0 * degree);
  EXPECT_FALSE(flat);
  EXPECT_NE(flat.reason().find("at rest"), std::string::npos) << flat.reason();
  const auto large = steady::slope_of_flux(classical_2, 0.0046);
  EXPECT_FALSE(large);
  EXPECT_NE(large.reason().find("exceeds the largest flux, 0.004593"), std::string::npos) << large.reason();
  EXPECT_FALSE(steady::slope_of_flux({table_2.grains, rheology::constant(0.4), 0.003, 0.3727, 9.81}, 0.001));
  EXPECT_FALSE(UniformFlow::at({table_2.grains, rheology::constant(0.4), 0.003, 0.3727, 9.81}, 0.5));
  EXPECT_THROW((void)steep.value(), std::bad_optional_access);
}

TEST(UniformFlow, SlopeOfFluxServesTinyAndHugeFluxesAndThinLayers) {
  for (const double Q : {1e-12, 1e-6, 0.0046, 10.0}) {
    const auto zeta = steady::slope_of_flux(table_2, Q);
    ASSERT_TRUE(zeta) << zeta.reason();
    EXPECT_NEAR(UniformFlow::at(table_2, *zeta)->flux() / Q, 1.0, 1e-9) << Q;
  }
  const Channel open{table_2.grains, base, 0.003, 0.0, 9.81};
  const auto zeta = steady::slope_of_flux(open, 0.0046, 0.01);
  ASSERT_TRUE(zeta) << zeta.reason();
  EXPECT_NEAR(UniformFlow::at(open, *zeta, 0.01)->flux(), 0.0046, 1e-12);
}

TEST(UniformFlow, BadInputIsRefused) {
  using std::invalid_argument;
  EXPECT_THROW((void)UniformFlow::at(table_2, 0.0), invalid_argument);
  EXPECT_THROW((void)UniformFlow::at(table_2, 1.6), invalid_argument);
  EXPECT_THROW((void)UniformFlow::at(table_2, std::nan("")), invalid_argument);
  EXPECT_THROW((void)UniformFlow::at(table_2, 0.8, -1.0), invalid_argument);
  EXPECT_THROW((void)UniformFlow::at({table_2.grains, base, 0.003, 0.0, 9.81}, 0.5), invalid_argument);
  EXPECT_THROW((void)UniformFlow::at({table_2.grains, base, -0.003, 0.1, 9.81}, 0.5), invalid_argument);
  EXPECT_THROW((void)steady::slope_of_flux(table_2, 0.0), invalid_argument);
}
}  // namespace
