#include "steady/bagnold.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "steady/uniform_flow.hpp"
#include "support/reference.hpp"

/// (B1), (B2) and (A4) in closed form, against 25-digit values and against the quadrature of the flow between walls,
/// with the walls away and moving away.
namespace {
using namespace talus;
using nlohmann::json;
using steady::BagnoldFlow;
using steady::Channel;

constexpr double degree = std::numbers::pi / 180.0;

double off(double value, double reference) { return std::abs(value / reference - 1.0); }

Channel channel_of(const json& p, const std::string& law, double mu_w) {
  return {support::grains_of(p),
          law == "partial" ? rheology::Law(support::partial_of(p)) : rheology::Law(support::classical_of(p)), p["W"],
          mu_w, p["g"]};
}

/// Calls `act` with the channel, angle, thickness and exact values (an object, or null) of each reference case.
template <class F>
void for_each_case(const F& act) {
  static const json cases = support::reference("steady_uniform.json").at("cases");
  for (const auto& each : cases)
    for (const auto& row : each["bagnold"])
      for (const std::string law : {"partial", "classical"})
        act(channel_of(each["parameters"], law, each["parameters"]["mu_w"]), row["zeta_deg"].get<double>() * degree,
            row["h"].get<double>(), row[law]);
}

TEST(BagnoldFlow, EqualsTheReferenceAndTheQuadrature) {
  int compared = 0, unsolvable = 0;
  for_each_case([&](const Channel& channel, double zeta, double h, const json& exact) {
    const auto flow = BagnoldFlow::at(channel, zeta, h);
    ASSERT_EQ(static_cast<bool>(flow), exact.is_object()) << flow.reason();
    if (!flow) {
      EXPECT_FALSE(flow.reason().empty());
      ++unsolvable;
      return;
    }
    EXPECT_LT(off(flow->inertial_number(), exact["I"]), 1e-12);
    EXPECT_LT(off(flow->surface_speed(), exact["u_surf"]), 1e-12);
    EXPECT_LT(off(flow->speed(-0.5 * h), exact["u_half"]), 1e-12);
    EXPECT_LT(off(flow->flux() / channel.grains.rho(), exact["q_m2_s"]), 1e-12);
    Channel open = channel;
    open.mu_w = 0.0;
    const auto quadrature = steady::UniformFlow::at(open, zeta, h);
    for (const double share : {0.0, 0.1, 0.7, 0.999})
      EXPECT_LT(off(flow->speed(-share * h), quadrature->speed(-share * h)), 1e-11) << share;
    EXPECT_LT(off(flow->flux() * channel.gap, quadrature->flux()), 1e-11);
    EXPECT_LT(off(flow->froude(), quadrature->froude(h)), 1e-11);
    EXPECT_LT(off(flow->froude(), 0.4 * std::sqrt(channel.grains.Phi) / channel.grains.d * flow->inertial_number() * h),
              1e-13);
    ++compared;
  });
  EXPECT_GT(compared, 10);
  EXPECT_GT(unsolvable, 0);
}

TEST(BagnoldFlow, IsTheLimitOfWallsThatLoseTheirFriction) {
  for_each_case([](const Channel& channel, double zeta, double h, const json&) {
    const auto flow = BagnoldFlow::at(channel, zeta, h);
    if (!flow) return;
    const auto deficit = [&](double mu_w) {
      Channel walled = channel;
      walled.mu_w = mu_w;
      return 1.0 - steady::UniformFlow::at(walled, zeta, h)->flux() / (flow->flux() * channel.gap);
    };
    // Friction takes away in proportion to mu_w.
    const double small = 1e-5 * channel.gap / h * std::tan(zeta);
    EXPECT_NEAR(deficit(small) / deficit(2.0 * small), 0.5, 1e-3);
    EXPECT_GT(deficit(small), 0.0);
    EXPECT_LT(deficit(1e-12), 1e-9);
  });
}

TEST(BagnoldFlow, ItsShearRateIsTheSlopeOfItsSpeed) {
  const Channel channel{rheology::grains(2500.0, 0.6, 0.00073), rheology::classical(0.4, 0.9, 1.3), 0.003, 0.3, 9.81};
  const auto flow = BagnoldFlow::at(channel, 28.0 * degree, 0.01);
  for (const double z : {-0.001, -0.005, -0.0095}) {
    constexpr double dz = 1e-6;
    EXPECT_LT(off((flow->speed(z + dz) - flow->speed(z - dz)) / (2.0 * dz), flow->shear_rate(z)), 1e-6);
  }
  EXPECT_EQ(flow->shear_rate(0.0), 0.0);
  EXPECT_EQ(flow->speed(-0.01), 0.0);
}

TEST(BagnoldFlow, RefusesWhatLiesOutsideAndSaysWhyThereIsNone) {
  const Channel channel{rheology::grains(2500.0, 0.6, 0.00073), rheology::classical(0.4, 0.9, 1.3), 0.003, 0.3, 9.81};
  EXPECT_NE(BagnoldFlow::at(channel, 20.0 * degree, 0.01).reason().find("at rest"), std::string::npos);
  EXPECT_NE(BagnoldFlow::at(channel, 45.0 * degree, 0.01).reason().find("is not below 0.9"), std::string::npos);
  EXPECT_THROW((void)BagnoldFlow::at(channel, 0.5, 0.0), std::invalid_argument);
  EXPECT_THROW((void)BagnoldFlow::at(channel, 2.0, 0.01), std::invalid_argument);
  EXPECT_THROW((void)BagnoldFlow::at(channel, 28.0 * degree, 0.01)->speed(0.001), std::invalid_argument);
  EXPECT_THROW((void)BagnoldFlow::at(channel, 28.0 * degree, 0.01)->speed(-0.011), std::invalid_argument);
}
}  // namespace
