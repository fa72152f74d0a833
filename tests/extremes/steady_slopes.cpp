#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "rheology/checks.hpp"
#include "steady/layer_mean.hpp"
#include "steady/slope.hpp"
#include "support/steady_cases.hpp"
#include "support/tanh_sinh.hpp"

/// Steady uniform flow at the ends of the range of slopes: just above rest, just below mu_d, near level and near upright.
namespace {
using namespace talus;
using rheology::checks::text;
using steady::Channel;
using steady::UniformFlow;
using support::channel_named;
using support::off;

constexpr double infinity = std::numeric_limits<double>::infinity();

double gradient(const Channel& c) { return c.mu_w / c.gap; }
/// sqrt(Phi g cos zeta)/d.
double rate(const Channel& c, double mu) {
  return std::sqrt(c.grains.Phi * c.gravity / std::hypot(1.0, mu)) / c.grains.d;
}
/// What the integral of (mu - m)^(3/2) I dm is multiplied by to give Q.
double flux_factor(const Channel& c, double mu) {
  return c.grains.rho() * c.gap * rate(c, mu) * std::pow(gradient(c), -2.5);
}
double speed_factor(const Channel& c, double mu) { return rate(c, mu) * std::pow(gradient(c), -1.5); }

/// Integrals of y^(k/2) I dy over y = mu - m from 0 to a, for the classical law: I = I_0 (a - y)/(e + y), where a and e are
/// the distances of mu from mu_s and to mu_d. In closed form, or as a series of positive terms where that would cancel.
double classical_integral(const rheology::Classical& law, double a, double e, int k) {
  const double D = law.mu_d - law.mu_s, p = 0.5 * k;
  if (a < 0.3 * D) {
    // 1/(e + y) = 1/(D - (a - y)), expanded in (a - y)/D.
    double sum = 0.0;
    for (int j = 0; j < 60; ++j)
      sum += std::pow(a / D, j + 1) * std::exp(std::lgamma(p + 1.0) + std::lgamma(j + 2.0) - std::lgamma(p + j + 3.0));
    return law.I_0 * std::pow(a, p + 1.0) * sum;
  }
  const double angle = e > 0.0 ? std::atan(std::sqrt(a / e)) : 0.5 * std::numbers::pi;
  const double root = std::sqrt(a);
  const double quotient = k == 1 ? 2.0 * root - 2.0 * std::sqrt(e) * angle
                                 : 2.0 / 3.0 * a * root - 2.0 * e * root + 2.0 * e * std::sqrt(e) * angle;
  return law.I_0 * (D * quotient - std::pow(a, p + 1.0) / (p + 1.0));
}

/// The same for any law by another rule in another variable than the code's, in pieces between the bends of the law.
double independent_integral(const rheology::Law& law, double mu, int k, double step) {
  const double rest = rheology::friction_at_rest(law);
  std::vector<double> ends{mu};
  if (const auto* partial = std::get_if<rheology::PartiallyRegularised>(&law))
    for (const double m : {partial->mu_d, partial->mu_N, partial->friction(partial->tiny_I)})
      if (m < mu) ends.push_back(m);
  ends.push_back(rest);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double top = ends[i], bottom = ends[i + 1];
    sum += support::tanh_sinh(
        [&](double above_bottom, double below_top) {
          const double I = above_bottom < below_top ? rheology::inverse(law, bottom, -above_bottom)
                                                    : rheology::inverse(law, top, below_top);
          return std::pow((mu - top) + below_top, 0.5 * k) * I;
        },
        top - bottom, step);
  }
  return sum;
}

TEST(SteadySlopes, ClassicalFlowIsItsClosedFormFromRestToTheSteepestSlope) {
  for (const char* name : {"T1_table1", "T2_table2"}) {
    const Channel c = channel_named(name, "classical");
    const auto law = std::get<rheology::Classical>(c.law);
    std::vector<double> slopes;
    for (const double step : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.1}) {
      slopes.push_back(law.mu_s + step);
      slopes.push_back(law.mu_d - step);
    }
    for (const double mu : slopes) {
      const double a = mu - law.mu_s, e = law.mu_d - mu;
      const auto flow = UniformFlow::at_friction(c, mu);
      ASSERT_TRUE(flow) << flow.reason();
      const std::string where = std::string(name) + " at mu_s + " + text(a) + " = mu_d - " + text(e);
      EXPECT_LT(off(flow->flux(), flux_factor(c, mu) * classical_integral(law, a, e, 3)), 1e-12) << where;
      EXPECT_LT(off(flow->surface_speed(), speed_factor(c, mu) * classical_integral(law, a, e, 1)), 1e-12) << where;
      EXPECT_LT(off(flow->inertial_number(0.0), law.I_0 * a / e), 1e-14) << where;
      EXPECT_LT(off(-flow->z_st(), a / gradient(c)), 1e-14) << where;
      for (const double share : {0.5, 0.01})
        EXPECT_LT(off(flow->speed(-flow->depth_at_share(share)), share * flow->surface_speed()), 1e-10) << where;
    }
  }
}

TEST(SteadySlopes, JustAboveRestTheClassicalFluxFollowsItsExpansion) {
  const Channel c = channel_named("T2_table2", "classical");
  const auto law = std::get<rheology::Classical>(c.law);
  const double D = law.mu_d - law.mu_s;
  for (const double step : {1e-12, 1e-6, 1e-4}) {
    const double mu = law.mu_s + step, a = mu - law.mu_s;
    const double leading = flux_factor(c, mu) * law.I_0 * (4.0 / 35.0) * std::pow(a, 3.5) / D;
    const double ratio = UniformFlow::at_friction(c, mu)->flux() / leading;
    EXPECT_NEAR(ratio, 1.0 + 4.0 / 9.0 * a / D, std::max(1e-12, (a / D) * (a / D)));
  }
}

TEST(SteadySlopes, AtTheSteepestSlopeTheLimitIsReached) {
  for (const char* name : {"T1_table1", "T2_table2"}) {
    const Channel c = channel_named(name, "classical");
    const auto law = std::get<rheology::Classical>(c.law);
    const double D = law.mu_d - law.mu_s;
    const auto limit = UniformFlow::steepest(c);
    ASSERT_TRUE(limit.has_value());
    EXPECT_LT(off(limit->flux(), flux_factor(c, law.mu_d) * law.I_0 * (4.0 / 15.0) * std::pow(D, 2.5)), 1e-12);
    EXPECT_LT(off(limit->surface_speed(), speed_factor(c, law.mu_d) * law.I_0 * (4.0 / 3.0) * std::pow(D, 1.5)), 1e-12);
    EXPECT_LT(off(limit->flux(), steady::maximal_flux(c).value()), 1e-12);
    // Over a base the closed form holds, too.
    const double H = 0.3 * limit->depth();
    EXPECT_LT(off(UniformFlow::steepest(c, H)->flux(), steady::maximal_flux(c, H).value()), 1e-12);
    EXPECT_LT(steady::maximal_flux(c, H).value(), steady::maximal_flux(c).value());
  }
  EXPECT_FALSE(UniformFlow::steepest(channel_named("T2_table2", "partial")).has_value());
}

TEST(SteadySlopes, AnotherRuleInAnotherVariableGivesTheSameIntegrals) {
  for (const char* name : {"T1_table1", "T2_table2"}) {
    const Channel c = channel_named(name, "partial");
    const auto printed = std::get<rheology::PartiallyRegularised>(c.law);
    const rheology::Classical base{printed.mu_s, printed.mu_d, printed.I_0};
    for (const double mu_inf : {printed.mu_inf, 1e-3, 1e-8, 0.0}) {
      const rheology::Law law = rheology::partially_regularised(base, mu_inf, printed.alpha, printed.I_N);
      Channel other = c;
      other.law = law;
      for (const double mu :
           {0.02, 0.07, 0.15, 0.3, 0.42, 0.5, printed.mu_d - 1e-12, printed.mu_d + 1e-12, 0.95, 1.5, 30.0, 1e4}) {
        if (mu_inf == 0.0 && mu >= printed.mu_d) continue;
        const auto flow = UniformFlow::at_friction(other, mu);
        ASSERT_TRUE(flow) << flow.reason();
        const std::string where = std::string(name) + " mu_inf " + text(mu_inf) + " tan zeta " + text(mu);
        const double flux = flux_factor(other, mu) * independent_integral(law, mu, 3, 1.0 / 64);
        const double speed = speed_factor(other, mu) * independent_integral(law, mu, 1, 1.0 / 64);
        // The rule itself has converged.
        EXPECT_LT(off(flux_factor(other, mu) * independent_integral(law, mu, 3, 1.0 / 32), flux), 1e-11) << where;
        EXPECT_LT(off(flow->flux(), flux), 2e-12) << where;
        EXPECT_LT(off(flow->surface_speed(), speed), 2e-12) << where;
      }
    }
  }
}

TEST(SteadySlopes, NearlyLevelThePartialLawCreepsAsItsSlopeAtRestSays) {
  const Channel c = channel_named("T2_table2", "partial");
  const double softness = 1.0 / rheology::friction_slope(c.law, 0.0);  // dI/dmu at rest
  for (const double mu : {1e-12, 1e-16, 1e-20}) {
    const auto flow = UniformFlow::at_friction(c, mu);
    ASSERT_TRUE(flow) << flow.reason();
    EXPECT_LT(off(flow->flux(), flux_factor(c, mu) * softness * (4.0 / 35.0) * std::pow(mu, 3.5)), 1e-10) << mu;
    EXPECT_LT(off(flow->surface_speed(), speed_factor(c, mu) * softness * (4.0 / 15.0) * std::pow(mu, 2.5)), 1e-10)
        << mu;
    EXPECT_LT(off(flow->zeta(), mu), 1e-15);
  }
}

TEST(SteadySlopes, NearlyUprightThePartialFluxFollowsItsLinearBranch) {
  for (const char* name : {"T1_table1", "T2_table2"}) {
    const Channel c = channel_named(name, "partial");
    const double mu_inf = std::get<rheology::PartiallyRegularised>(c.law).mu_inf;
    for (const double mu : {1e13, 1e15}) {
      const auto flow = UniformFlow::at_friction(c, mu);
      ASSERT_TRUE(flow) << flow.reason();
      EXPECT_LT(off(flow->flux(), flux_factor(c, mu) * (4.0 / 35.0) * std::pow(mu, 3.5) / mu_inf), 1e-11) << mu;
      EXPECT_LT(off(flow->surface_speed(), speed_factor(c, mu) * (4.0 / 15.0) * std::pow(mu, 2.5) / mu_inf), 1e-11)
          << mu;
    }
    const auto last = UniformFlow::at(c, std::nextafter(0.5 * std::numbers::pi, 0.0));
    ASSERT_TRUE(last) << last.reason();
    for (const double value : {last->flux(), last->surface_speed(), last->depth_at_share(0.01),
                               steady::layer_mean(*last).froude, last->inertial_number(0.0)})
      EXPECT_TRUE(std::isfinite(value) && value > 0.0) << value;
  }
}

TEST(SteadySlopes, WithoutMuInfThePartialLawDegeneratesAtMuD) {
  Channel c = channel_named("T2_table2", "partial");
  const auto printed = std::get<rheology::PartiallyRegularised>(c.law);
  const rheology::Classical base{printed.mu_s, printed.mu_d, printed.I_0};
  const auto law = rheology::partially_regularised(base, 0.0, printed.alpha, printed.I_N);
  c.law = law;
  for (const double mu : {0.9, 0.9 + 1e-12, 2.0}) {
    const auto none = UniformFlow::at_friction(c, mu);
    EXPECT_FALSE(none);
    EXPECT_NE(none.reason().find("is not below 0.9 (41.9872 degrees), the largest friction of the partially "
                                 "regularised law with mu_inf = 0; "),
              std::string::npos)
        << none.reason();
  }
  // Q_max: the creep below mu(I_N) by the other rule, (mu_d - m)^(1/2) I_0 (m - mu_s) above it in closed form.
  const double D = 0.5, Y = law.mu_d - law.mu_N;
  const double creep = support::tanh_sinh(
      [&](double m, double) { return std::pow(law.mu_d - m, 1.5) * rheology::inverse(c.law, m); }, law.mu_N);
  const double rational = law.I_0 * (2.0 / 3.0 * D * std::pow(Y, 1.5) - 0.4 * std::pow(Y, 2.5));
  const double Q_max = steady::maximal_flux(c).value();
  EXPECT_LT(off(Q_max, flux_factor(c, law.mu_d) * (creep + rational)), 1e-11);
  const auto below = steady::flow_of_flux(c, Q_max * (1.0 - 1e-9));
  ASSERT_TRUE(below) << below.reason();
  EXPECT_LT(off(below->flux(), Q_max), 2e-9);
  EXPECT_LT(below->tan_zeta(), law.mu_d);
  const auto above = steady::flow_of_flux(c, Q_max * (1.0 + 1e-9));
  EXPECT_FALSE(above);
  EXPECT_NE(above.reason().find("exceeds the largest flux, " + text(UniformFlow::steepest(c)->flux())),
            std::string::npos)
      << above.reason();
  // As mu_inf -> 0 the flow below mu_d tends to this one, in proportion to mu_inf.
  const double exact = UniformFlow::at_friction(c, 0.8)->flux();
  double before = infinity;
  for (const double mu_inf : {1e-4, 1e-6, 1e-8}) {
    Channel near = c;
    near.law = rheology::partially_regularised(base, mu_inf, printed.alpha, printed.I_N);
    const double change = off(UniformFlow::at_friction(near, 0.8)->flux(), exact);
    EXPECT_LT(change, 0.011 * before);
    before = change;
  }
}
}  // namespace
