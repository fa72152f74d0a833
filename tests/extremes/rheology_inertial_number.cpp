#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rheology/viscosity.hpp"
#include "rheology/well_posedness.hpp"
#include "support/extreme_laws.hpp"

/// mu(I) and all that is made of it, from I = 0 to 1e300.
namespace {
using namespace talus;
using rheology::Law;
using support::extreme_I;
using support::extreme_laws;

constexpr double eps = std::numeric_limits<double>::epsilon();
using Long = long double;

/// Difference relative to the reference; absolute below the normal doubles, where no digits are left.
double off(Long value, Long reference) {
  const Long size = std::max(std::abs(reference), static_cast<Long>(std::numeric_limits<double>::min()));
  return static_cast<double>(std::abs(value - reference) / size);
}

/// The printed formulas, (1.3) and (3.19) with (3.20), and I mu', in 64 bits of mantissa.
struct Printed {
  Long mu, log_slope;
};
Printed printed(const Law& law, Long I) {
  if (const auto* c = std::get_if<rheology::Classical>(&law)) {
    const Long step = static_cast<Long>(c->mu_d) - c->mu_s, r = c->I_0 / I;
    return {c->mu_s + step / (r + 1.0L), step * r / ((r + 1.0L) * (r + 1.0L))};
  }
  if (const auto* p = std::get_if<rheology::PartiallyRegularised>(&law)) {
    const auto rational = [p](Long x) {
      return (static_cast<Long>(p->mu_s) * p->I_0 + p->mu_d * x + p->mu_inf * x * x) / (p->I_0 + x);
    };
    if (I > p->I_N) {
      const Long d = p->I_0 + I, m = p->mu_inf;
      return {rational(I),
              I * ((static_cast<Long>(p->mu_d) - p->mu_s) * p->I_0 + 2.0L * m * p->I_0 * I + m * I * I) / (d * d)};
    }
    const Long mu_N = rational(p->I_N), folds = p->alpha / (mu_N * mu_N) + std::log(p->I_N / I);
    return {std::sqrt(p->alpha / folds), 0.5L * std::sqrt(p->alpha / folds) / folds};
  }
  return {std::get<rheology::Constant>(law).mu_s, 0.0L};
}

bool has_printed_value(const Law& law, double I) {
  return I > 0.0 &&
         !(std::holds_alternative<rheology::PartiallyRegularised>(law) && I <= rheology::PartiallyRegularised::tiny_I);
}

TEST(ExtremeI, FrictionAndNuKeepTheirDigits) {
  int compared = 0;
  for (const auto& [name, law] : extreme_laws())
    for (const double I : extreme_I()) {
      if (!has_printed_value(law, I)) continue;
      const auto exact = printed(law, I);
      EXPECT_LT(off(rheology::friction(law, I), exact.mu), 2e-15) << name << " I " << I;
      EXPECT_LT(off(rheology::friction_log_slope(law, I), exact.log_slope), 4e-15) << name << " I " << I;
      const auto r = rheology::response(law, I);
      EXPECT_LT(off(r.nu, exact.log_slope / exact.mu), 6e-15) << name << " I " << I;
      // Cancels where nu is near 2.
      EXPECT_NEAR(r.q, static_cast<double>(exact.mu - 0.5L * exact.log_slope), 4e-15 * r.mu * (1.0 + r.nu));
      ++compared;
    }
  EXPECT_GT(compared, 15000);
}

TEST(ExtremeI, NothingIsNotANumber) {
  const rheology::Grains grains = rheology::grains(2500.0, 0.6, 0.00073);
  for (const auto& [name, law] : extreme_laws())
    for (const double I : extreme_I()) {
      const auto r = rheology::response(law, I);
      EXPECT_TRUE(std::isfinite(r.mu) && std::isfinite(r.nu) && std::isfinite(r.q)) << name << " I " << I;
      EXPECT_FALSE(std::isnan(rheology::condition_C(r))) << name << " I " << I;  // infinite where q^2 is
      EXPECT_FALSE(std::isnan(rheology::max_growth(r))) << name << " I " << I;
      EXPECT_LE(std::abs(rheology::worst_direction(r)), 1.0) << name << " I " << I;
      EXPECT_TRUE(std::isfinite(rheology::friction_slope(law, I))) << name << " I " << I;
      if (I > 0.0) { EXPECT_FALSE(std::isnan(rheology::growth_scale(grains, r, I, 1e3))) << name << " I " << I; }
    }
}

TEST(ExtremeI, GrowthInTheWorstDirectionIsTheLargest) {
  for (const auto& [name, law] : extreme_laws())
    for (const double I : extreme_I()) {
      const auto r = rheology::response(law, I);
      if (std::isinf(rheology::max_growth(r))) continue;
      // 1 - q s is c = sqrt(1 - q^2) there, and loses its digits as q nears 1.
      EXPECT_NEAR(rheology::growth(r, rheology::worst_direction(r)), rheology::max_growth(r),
                  1e-14 * (r.q * r.q + r.nu) / std::sqrt((1.0 - r.q) * (1.0 + r.q)) + 1e-300)
          << name << " I " << I;
    }
}

TEST(ExtremeI, FrictionNeverFalls) {
  support::LogUniform random(1);
  std::vector<support::NamedLaw> laws = extreme_laws();
  for (int i = 0; i < 300; ++i)
    laws.push_back({"random " + std::to_string(i), support::random_partial(random, i % 30)});
  for (const auto& [name, law] : laws) {
    double last = rheology::friction_at_rest(law);
    std::vector<double> list = extreme_I();
    if (const auto* p = std::get_if<rheology::PartiallyRegularised>(&law))
      for (const double I : {p->I_N, std::nextafter(p->I_N, 0.0), std::nextafter(p->I_N, 1e300)}) list.push_back(I);
    std::sort(list.begin(), list.end());
    for (const double I : list) {
      const double mu = rheology::friction(law, I);
      ASSERT_GE(mu, last * (1.0 - 2.0 * eps)) << name << " I " << I;
      ASSERT_GE(rheology::friction_log_slope(law, I), 0.0) << name << " I " << I;
      ASSERT_LE(mu, rheology::friction_bound(law)) << name << " I " << I;
      last = mu;
    }
  }
}

/// One rounding of mu moves I by eps/nu of itself: nothing better can be asked of an inverse, and nothing at all once
/// mu has rounded to the value it saturates at.
TEST(ExtremeI, InverseUndoesFrictionAsFarAsRoundingAllows) {
  int tight = 0, limited = 0, saturated = 0;
  for (const auto& [name, law] : extreme_laws())
    for (const double I : extreme_I()) {
      const auto r = rheology::response(law, I);
      double back = 0.0;
      try {
        back = rheology::inverse(law, r.mu);
      } catch (const std::domain_error&) {
        EXPECT_GE(r.mu, rheology::friction_bound(law)) << name << " I " << I;
        ++saturated;
        continue;
      }
      if (r.nu < 1e-3) {
        EXPECT_LT(off(back, I), 1e-14 + 8.0 * eps / r.nu) << name << " I " << I;
        ++limited;
      } else {
        EXPECT_LT(off(back, I), 1e-12) << name << " I " << I;
        ++tight;
      }
    }
  EXPECT_GT(tight, 5000);
  EXPECT_GT(limited, 1000);
  EXPECT_GT(saturated, 1000);
}

TEST(ExtremeI, FrictionUndoesItsInverseUpToTheLastFriction) {
  for (const auto& [name, law] : extreme_laws()) {
    if (std::holds_alternative<rheology::Constant>(law)) continue;
    const double low = rheology::friction_at_rest(law), high = rheology::friction_bound(law);
    if (low == high) continue;
    for (double mu = 1e-100; mu < 1e300; mu *= 1.7) {  // below, I is no double any more
      if (!(mu >= low && mu < high)) continue;
      try {
        const double I = rheology::inverse(law, mu);
        // One rounding of I is worth nu roundings of mu: much on the cliff of a tiny alpha.
        EXPECT_LT(off(rheology::friction(law, I), mu), 1e-12 + 4.0 * eps * rheology::response(law, I).nu)
            << name << " mu " << mu;
      } catch (const std::domain_error& error) {
        EXPECT_NE(std::string(error.what()).find("1.8e308"), std::string::npos) << name << error.what();
      }
    }
    for (const double mu : {low, std::nextafter(low, 1e300), std::isfinite(high) ? std::nextafter(high, 0.0) : 1.0})
      EXPECT_LT(off(rheology::friction(law, rheology::inverse(law, mu)), mu), 1e-14) << name << " mu " << mu;
  }
}

TEST(ExtremeI, BranchesMeetAtI_NToTheLastBitWithAStatedJumpOfSlope) {
  for (const auto& [name, law] : extreme_laws()) {
    const auto* p = std::get_if<rheology::PartiallyRegularised>(&law);
    if (!p) continue;
    const double above = std::nextafter(p->I_N, 1e300), below = std::nextafter(p->I_N, 0.0);
    EXPECT_EQ(p->friction(p->I_N), p->mu_N) << name;
    EXPECT_LT(off(p->friction(above), p->mu_N), 3.0 * eps) << name;
    // One ulp of I is worth nu ulp of mu, which is a cliff where alpha is tiny.
    EXPECT_LT(off(p->friction(below), p->mu_N), 3.0 * eps * (1.0 + 0.5 / p->folds_N)) << name;
    EXPECT_EQ(p->inverse(p->mu_N), p->I_N) << name;
    EXPECT_GE(p->inverse(std::nextafter(p->mu_N, 1e300)), p->I_N) << name;
    EXPECT_LT(off(p->log_slope(p->I_N), 0.5L * p->mu_N / p->folds_N), 2e-15) << name;
    EXPECT_LT(off(p->log_slope(above), printed(law, above).log_slope), 1e-14) << name;
  }
  // Table 1: the slope falls by 4.3 % at the printed I_N, and by 4.8 % at the neutral point that it rounds.
  const auto jump = [](const Law& law) {
    const double I_N = std::get<rheology::PartiallyRegularised>(law).I_N;
    return rheology::friction_slope(law, std::nextafter(I_N, 1.0)) / rheology::friction_slope(law, I_N) - 1.0;
  };
  EXPECT_NEAR(jump(extreme_laws()[2].law), -0.04265, 1e-5);
  EXPECT_NEAR(jump(extreme_laws()[3].law), -0.04804, 1e-5);
}

TEST(ExtremeI, DualsCarryTheSlopeEverywhere) {
  for (const auto& [name, law] : extreme_laws())
    for (const double I : extreme_I()) {
      const auto dual = rheology::friction(law, core::Dual<1>::input(I, 0));
      EXPECT_LT(off(dual.value, rheology::friction(law, I)), 2.0 * eps * (1.0 + rheology::response(law, I).nu))
          << name << " I " << I;
      if (has_printed_value(law, I)) {
        // The derivative of the saturation is a denormal number beyond I = 1e154.
        const Long slope = printed(law, I).log_slope / I;
        EXPECT_LT(std::abs(dual.slope[0] - slope), 4e-15L * slope + 1e-317L) << name << " I " << I;
      } else if (I < 1e-220) {  // at rest, and where creep's parabola is still straight
        const double rise = rheology::friction(law, 1e-250) - rheology::friction_at_rest(law);
        const auto* classical = std::get_if<rheology::Classical>(&law);
        const double straight = classical ? (classical->mu_d - classical->mu_s) / classical->I_0 : rise / 1e-250;
        EXPECT_LT(off(dual.slope[0], straight), 1e-14) << name << " I " << I;
      }
    }
}

TEST(ExtremeI, ViscosityIsFiniteAtRestWithoutPressureAndInTheFastestFlow) {
  const rheology::Grains grains = rheology::grains(2500.0, 0.6, 0.00073);
  const std::vector<rheology::Regularisation> switches{{}, {.p_0 = 0.1, .eta_max = 1e4, .cap = rheology::Cap::smooth}};
  for (const auto& [name, law] : extreme_laws())
    for (const auto& regularisation : switches)
      for (const double rate : {0.0, 1e-150, 1e-12, 1.0, 1e6, 1e75, 1e150})
        for (const double p : {-1e15, -1.0, 0.0, 1e-300, 1e-12, 1.0, 1e15}) {
          const auto eta = rheology::viscosity(law, grains, regularisation, core::Dual<2>::input(rate * rate, 0),
                                               core::Dual<2>(0.0), core::Dual<2>::input(p, 1));
          EXPECT_TRUE(std::isfinite(eta.value) && eta.value >= 0.0) << name << " rate " << rate << " p " << p;
          EXPECT_TRUE(std::isfinite(eta.slope[0]) && std::isfinite(eta.slope[1]))
              << name << " rate " << rate << " p " << p << " " << eta.slope[0] << " " << eta.slope[1];
        }
}
}  // namespace
