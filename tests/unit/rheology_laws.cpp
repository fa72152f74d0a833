#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "rheology/law.hpp"
#include "support/reference.hpp"

namespace {
using namespace talus;
using rheology::Law;

const rheology::Classical base = rheology::classical(0.4, 0.9, 1.3);
const rheology::PartiallyRegularised table_2 = rheology::partially_regularised(base, 1.3, 1.9, 0.05178);
const std::vector<Law> every_law{base, table_2, rheology::constant(0.4)};

const nlohmann::json& reference_laws() {
  static const nlohmann::json all = support::reference("rheology.json").at("laws");
  return all;
}

/// Relative difference.
double off(double value, double reference) { return std::abs(value / reference - 1.0); }

template <class E>
std::string message(const std::function<void()>& act) {
  try {
    act();
  } catch (const E& e) { return e.what(); }
  return "nothing thrown";
}

TEST(Laws, EqualTheReferenceCurves) {
  int compared = 0;
  for (const auto& law : reference_laws()) {
    const auto classical = support::classical_of(law["parameters"]);
    const auto partial = support::partial_of(law["parameters"]);
    EXPECT_LT(off(partial.A, law["A"]), 1e-13);
    EXPECT_LT(off(partial.friction_at_I_N(), law["mu_N"]), 1e-13);
    for (const auto& row : law["curves"]) {
      const double I = row["I"];
      EXPECT_LT(off(partial.friction(I), row["mu_p"]), 1e-13) << I;
      EXPECT_LT(off(rheology::friction_slope(Law(partial), I), row["dmu_p"]), 1e-12) << I;
      EXPECT_LT(off(classical.friction(I), row["mu_c"]), 1e-13) << I;
      EXPECT_LT(off(rheology::friction_slope(Law(classical), I), row["dmu_c"]), 1e-12) << I;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 44);
}

TEST(Laws, InverseEqualsTheReference) {
  int compared = 0;
  for (const auto& law : reference_laws()) {
    const auto classical = support::classical_of(law["parameters"]);
    const auto partial = support::partial_of(law["parameters"]);
    for (const auto& row : law["inverse"]) {
      // I = A exp(-alpha/mu^2) magnifies the rounding of mu and A by up to 2 alpha/mu^2 = 380 at mu = 0.1.
      EXPECT_LT(off(partial.inverse(row["mu"]), row["I_p"]), 1e-12) << row["mu"];
      if (row["I_c"].is_number() && row["I_c"] > 0.0) {
        EXPECT_LT(off(classical.inverse(row["mu"]), row["I_c"]), 1e-12) << row["mu"];
      }
      ++compared;
    }
  }
  EXPECT_EQ(compared, 36);
}

TEST(Laws, InverseUndoesFriction) {
  for (double I = 1e-199; I < 1e15; I *= 31.0) {
    const double mu = table_2.friction(I);
    // One rounding of mu moves I by eps mu/(I mu') of itself.
    EXPECT_LT(off(table_2.inverse(mu), I), 8e-16 * (1.0 + mu / (I * rheology::friction_slope(Law(table_2), I)))) << I;
  }
  for (double I = 1e-6; I < 1e3; I *= 3.0) EXPECT_LT(off(base.inverse(base.friction(I)), I), 1e-9) << I;
  EXPECT_EQ(table_2.inverse(0.0), 0.0);
  for (const double I : {1e-210, 3e-201, 9.9e-201}) EXPECT_LT(off(table_2.inverse(table_2.friction(I)), I), 1e-13);
}

TEST(Laws, InverseWithoutAnswerNamesLawFrictionAndBound) {
  using std::domain_error;
  EXPECT_EQ(message<domain_error>([] { (void)rheology::inverse(base, 0.95); }),
            "classical: no inertial number has the friction mu = 0.95 (needs mu_s = 0.4 <= mu < mu_d = 0.9)");
  EXPECT_EQ(message<domain_error>([] { (void)rheology::inverse(base, 0.9); }),
            "classical: no inertial number has the friction mu = 0.9 (needs mu_s = 0.4 <= mu < mu_d = 0.9)");
  EXPECT_THROW((void)base.inverse(0.3999), domain_error);
  EXPECT_THROW((void)base.inverse(std::nan("")), domain_error);
  EXPECT_EQ(message<domain_error>([] { (void)rheology::inverse(every_law[2], 0.4); }),
            "constant: no inertial number has the friction mu = 0.4 (every I has mu_s = 0.4)");
  EXPECT_THROW((void)table_2.inverse(-1e-9), domain_error);
  const auto bounded = rheology::partially_regularised(base, 0.0, 1.9, 0.05);
  EXPECT_LT(off(bounded.inverse(0.8), base.inverse(0.8)), 1e-14);
  EXPECT_THROW((void)bounded.inverse(0.9), domain_error);
}

TEST(Laws, DualsCarryTheSlopeOnBothBranches) {
  for (const Law& law : every_law)
    for (const double I : {1e-12, 1e-5, 0.0517, 0.0519, 0.3, 1e3}) {
      const double h = 1e-5 * I;
      const double central = (rheology::friction(law, I + h) - rheology::friction(law, I - h)) / (2.0 * h);
      const auto dual = rheology::friction(law, core::Dual<1>::input(I, 0));
      const double size = rheology::friction(law, I) / I;
      EXPECT_DOUBLE_EQ(dual.value, rheology::friction(law, I));
      EXPECT_NEAR(dual.slope[0], central, 1e-9 * size) << rheology::name(law) << I;
      EXPECT_NEAR(dual.slope[0], rheology::friction_slope(law, I), 1e-14 * size) << rheology::name(law) << I;
    }
}

TEST(Laws, AreFiniteAndMonotoneFromRestToHugeInertialNumbers) {
  for (const Law& law : every_law) {
    EXPECT_EQ(rheology::friction(law, 0.0), rheology::friction_at_rest(law));
    double last = rheology::friction_at_rest(law);
    for (const double I :
         {0.0, 1e-300, 5e-201, 1e-200, 2e-200, 1e-100, 1e-9, 0.05178, 0.05179, 1.0, 1e9, 1e160, 1e300}) {
      const auto mu = rheology::friction(law, core::Dual<1>::input(I, 0));
      EXPECT_TRUE(std::isfinite(mu.value) && std::isfinite(mu.slope[0])) << rheology::name(law) << I;
      EXPECT_GE(mu.value, last) << rheology::name(law) << I;
      EXPECT_GE(mu.slope[0], 0.0) << rheology::name(law) << I;
      last = mu.value;
    }
  }
}

TEST(Laws, CreepJoinsItsContinuationAndTheRationalBranch) {
  const double below = std::nextafter(table_2.tiny_I, 0.0), above = std::nextafter(table_2.tiny_I, 1.0);
  EXPECT_LT(off(table_2.friction(below), table_2.friction(above)), 1e-14);
  EXPECT_LT(off(rheology::friction_slope(Law(table_2), below), rheology::friction_slope(Law(table_2), above)), 1e-12);
  EXPECT_LT(off(table_2.friction(0.05178), table_2.friction(std::nextafter(0.05178, 1.0))), 1e-13);
}

TEST(Laws, FactoriesNameTheBadParameter) {
  using std::invalid_argument;
  EXPECT_EQ(message<invalid_argument>([] { (void)rheology::classical(0.4, 0.3, 1.3); }),
            "classical: mu_d = 0.3 must be at least mu_s = 0.4, or friction would fall as I grows");
  EXPECT_EQ(message<invalid_argument>([] { (void)rheology::partially_regularised(base, -1.0, 1.9); }),
            "partially regularised: mu_inf = -1 must be 0, or from 1e-100 to 1e+06");
  EXPECT_EQ(message<invalid_argument>([] {
              (void)rheology::partially_regularised({0.001, 0.002, 1.0}, 1.0, 1.9, 1e-9);
            }).substr(0, 34),
            "partially regularised: alpha = 1.9");
  EXPECT_THROW((void)rheology::classical(0.0, 0.3, 1.3), invalid_argument);
  EXPECT_THROW((void)rheology::classical(0.1, 0.3, std::nan("")), invalid_argument);
  EXPECT_THROW((void)rheology::partially_regularised(base, 1.3, 0.0), invalid_argument);
  EXPECT_THROW((void)rheology::partially_regularised(base, 1.3, 1.9, 0.0), invalid_argument);
  EXPECT_THROW((void)rheology::partially_regularised({0.4, 0.4, 1.0}, 1.3, 1.9), invalid_argument);  // no neutral point
  EXPECT_THROW((void)rheology::constant(-0.1), invalid_argument);
  EXPECT_THROW((void)rheology::grains(2500.0, 1.2, 1e-3), invalid_argument);
}
}  // namespace
