#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rheology/checks.hpp"
#include "steady/layer_mean.hpp"
#include "steady/slope.hpp"
#include "support/steady_cases.hpp"

/// Steady uniform flow over the whole range of gaps, grains, gravities, wall frictions and fluxes.
namespace {
using namespace talus;
using rheology::checks::text;
using steady::Channel;
using steady::UniformFlow;
using support::channel_named;
using support::off;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// K: all that Q(zeta) depends on besides the law.
double K(const Channel& c) {
  return c.grains.rho() * c.gap * std::sqrt(c.grains.Phi * c.gravity) / c.grains.d * std::pow(c.gap / c.mu_w, 2.5);
}

/// The channel with each of its scales at both ends of its range, one at a time and all together.
std::vector<Channel> extremes_of(const Channel& c) {
  std::vector<Channel> all;
  const auto add = [&](auto&& change) {
    Channel other = c;
    change(other);
    all.push_back(other);
  };
  for (const double W : {1e-6, 1e6}) add([&](Channel& o) { o.gap = W; });
  for (const double d : {1e-6, 0.1}) add([&](Channel& o) { o.grains.d = d; });
  for (const double g : {1e-3, 1e3}) add([&](Channel& o) { o.gravity = g; });
  for (const double mu_w : {1e-9, 1e3}) add([&](Channel& o) { o.mu_w = mu_w; });
  for (const double Phi : {1e-3, 1.0}) add([&](Channel& o) { o.grains.Phi = Phi; });
  for (const double rho : {1e-3, 1e5}) add([&](Channel& o) { o.grains.rho_star = rho; });
  all.push_back({{1e-3, 1e-3, 0.1}, c.law, 1e-6, 1e3, 1e-3});
  all.push_back({{1e5, 1.0, 1e-6}, c.law, 1e6, 1e-9, 1e3});
  return all;
}

TEST(SteadyScales, FluxIsKTimesAFunctionOfTheSlope) {
  for (const std::string law : {"partial", "classical"}) {
    const Channel c = channel_named("T2_table2", law);
    for (const double mu : {0.41, 0.6, 0.89}) {
      const auto reference = UniformFlow::at_friction(c, mu);
      for (const Channel& other : extremes_of(c)) {
        const auto flow = UniformFlow::at_friction(other, mu);
        ASSERT_TRUE(flow) << flow.reason();
        EXPECT_LT(off(flow->flux() / K(other), reference->flux() / K(c)), 1e-12);
        const auto depth = [](const Channel& x) { return x.gap / x.mu_w; };
        EXPECT_LT(off(flow->depth_at_share(0.01) / depth(other), reference->depth_at_share(0.01) / depth(c)), 1e-11);
        // u^2/(g h) goes with (h/d)^2 Phi, h the depth.
        const auto scale = [&](const Channel& x) { return depth(x) / x.grains.d * std::sqrt(x.grains.Phi); };
        EXPECT_LT(
            off(steady::layer_mean(*flow).froude / scale(other), steady::layer_mean(*reference).froude / scale(c)),
            1e-11);
      }
    }
  }
}

TEST(SteadyScales, SlopeOfFluxDependsOnFluxOverKAlone) {
  for (const std::string law : {"partial", "classical"}) {
    const Channel c = channel_named("T2_table2", law);
    const double mu = steady::flow_of_flux(c, 0.002)->tan_zeta();
    for (const Channel& other : extremes_of(c)) {
      const auto flow = steady::flow_of_flux(other, 0.002 / K(c) * K(other));
      ASSERT_TRUE(flow) << flow.reason();
      EXPECT_LT(off(flow->tan_zeta(), mu), 1e-13);
    }
  }
  const Channel c = channel_named("T2_table2", "classical");
  for (const Channel& other : extremes_of(c))
    EXPECT_LT(off(steady::maximal_flux(other).value() / K(other), steady::maximal_flux(c).value() / K(c)), 1e-13);
}

/// The relative change of the flux for one rounding error of tan zeta: what no answer to "which slope" can do better than.
double conditioning(const Channel& c, const UniformFlow& flow) {
  const double above_rest = flow.tan_zeta() - rheology::friction_at_rest(c.law);
  return 3.5 * epsilon * flow.tan_zeta() / above_rest;
}

TEST(SteadyScales, EveryFluxFromPicogramsToKilotonsHasItsSlopeOrAReason) {
  int found = 0, none = 0;
  for (const std::string law : {"partial", "classical"})
    for (const double W : {1e-6, 0.003, 1.0, 1e6}) {
      Channel c = channel_named("T2_table2", law);
      c.gap = W;
      for (double Q = 1e-12; Q < 2e6; Q *= 1e3) {
        const auto flow = steady::flow_of_flux(c, Q);
        const std::string where = law + " W " + text(W) + " Q " + text(Q);
        ASSERT_EQ(static_cast<bool>(flow), law == "partial" || Q < steady::maximal_flux(c).value()) << where;
        if (!flow) {
          EXPECT_NE(flow.reason().find("exceeds the largest flux, "), std::string::npos) << flow.reason();
          ++none;
          continue;
        }
        ++found;
        EXPECT_LT(off(flow->flux(), Q), 1e-12 + 4.0 * conditioning(c, *flow)) << where;
        if (law == "classical" && flow->tan_zeta() < 0.4 + 1e-4) {
          const double a = std::pow(Q * 35.0 / 4.0 * 0.5 / (K(c) * std::pow(1.16, -0.25) * 1.3), 2.0 / 7.0);
          EXPECT_NEAR((flow->tan_zeta() - 0.4) / a, 1.0, a + 2.0 * epsilon / a) << where;
        }
      }
    }
  EXPECT_GT(found, 30);
  EXPECT_GT(none, 5);
}

TEST(SteadyScales, WallFrictionGoesToZeroContinuously) {
  for (const std::string law : {"partial", "classical"}) {
    Channel c = channel_named("T2_table2", law);
    const double H = 0.02, mu = 0.6;
    Channel open = c;
    open.mu_w = 0.0;
    const auto bagnold = UniformFlow::at_friction(open, mu, H);
    const double I = rheology::inverse(c.law, mu), rate = std::sqrt(0.6 * 9.81 / std::hypot(1.0, mu)) / c.grains.d;
    EXPECT_LT(off(bagnold->surface_speed(), 2.0 / 3.0 * I * rate * std::pow(H, 1.5)), 1e-14);            // (B2)
    EXPECT_LT(off(bagnold->flux(), c.grains.rho() * c.gap * 0.4 * I * rate * std::pow(H, 2.5)), 1e-14);  // its integral
    const double change_of_I = 1.0 / rheology::friction_slope(c.law, I);
    for (const double mu_w : {1e-5, 1e-7, 1e-9, 1e-13, 1e-20, 1e-100, 1e-300, 5e-324}) {
      c.mu_w = mu_w;
      const auto flow = UniformFlow::at_friction(c, mu, H);
      ASSERT_TRUE(flow) << flow.reason();
      ASSERT_TRUE(flow->on_base());
      // dI = -dI/dmu (mu_w/W) s, integrated over the depth s.
      const double first_order = change_of_I * mu_w / c.gap * 0.6 * H / I;
      EXPECT_NEAR(bagnold->surface_speed() / flow->surface_speed() - 1.0, first_order,
                  30.0 * first_order * first_order + 1e-14)
          << law << " " << mu_w;
      EXPECT_TRUE(std::isfinite(steady::layer_mean(*flow).froude));
    }
    EXPECT_FALSE(steady::maximal_flux(open).has_value());
    EXPECT_FALSE(steady::maximal_flux(open, H).has_value());
    const auto by_flux = steady::flow_of_flux(open, bagnold->flux(), H);
    EXPECT_LT(off(by_flux->tan_zeta(), mu), 1e-14);
  }
}

TEST(SteadyScales, DepthAveragedSpeedsFindTheirSlopes) {
  for (const std::string law : {"partial", "classical"})
    for (const double mu_w : {0.0, 1e-12, 0.3727})
      for (const double H : {1e-5, 0.004, 10.0}) {
        Channel c = channel_named("T2_table2", law);
        c.mu_w = mu_w;
        for (const double mu : {0.4001, 0.5, 0.7, 0.85}) {
          const auto flow = UniformFlow::at_friction(c, mu, H);
          const double speed = steady::layer_mean(*flow).speed;
          const auto found = steady::flow_of_mean_speed(c, speed, H);
          ASSERT_TRUE(found) << found.reason();
          EXPECT_LT(off(steady::layer_mean(*found).speed, speed), 1e-9);
          // A gentler slope, whose flow ends above the base, may have the same average.
          if (flow->on_base() == found->on_base()) {
            EXPECT_LT(off(found->tan_zeta(), mu), 1e-9);
          } else EXPECT_LT(found->tan_zeta(), mu);
        }
      }
  Channel c = channel_named("T2_table2", "classical");
  const double limit = steady::layer_mean(*UniformFlow::steepest(c)).speed;
  EXPECT_TRUE(steady::flow_of_mean_speed(c, 0.999 * limit));
  const auto none = steady::flow_of_mean_speed(c, 1.001 * limit);
  EXPECT_FALSE(none);
  EXPECT_NE(none.reason().find("exceeds the largest depth-averaged speed, " + text(limit)), std::string::npos)
      << none.reason();
}
}  // namespace
