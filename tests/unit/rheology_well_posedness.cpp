#include "rheology/well_posedness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rheology/neutral_points.hpp"
#include "support/reference.hpp"

namespace {
using namespace talus;

const nlohmann::json& reference_laws() {
  static const nlohmann::json all = support::reference("rheology.json").at("laws");
  return all;
}

double off(double value, double reference) { return std::abs(value / reference - 1.0); }

TEST(WellPosedness, NeutralPointsEqualTheReference) {
  EXPECT_EQ(reference_laws().size(), 2U);
  for (const auto& law : reference_laws()) {
    const auto classical = rheology::neutral_points(support::classical_of(law["parameters"]));
    ASSERT_EQ(classical.size(), 2U);
    EXPECT_LT(off(classical[0], law["neutral_classical"][0]), 1e-12);
    EXPECT_LT(off(classical[1], law["neutral_classical"][1]), 1e-12);
    const auto partial = rheology::neutral_points(support::partial_of(law["parameters"]));
    ASSERT_EQ(partial.size(), 1U);
    EXPECT_LT(off(partial[0], law["neutral_partial"]), 1e-12);
    const auto bounds = rheology::ellipticity_bounds(support::partial_of(law["parameters"]));
    ASSERT_EQ(bounds.size(), 1U);
    EXPECT_LT(off(bounds[0], law["ellipticity_bound"]), 1e-12);
    EXPECT_TRUE(rheology::ellipticity_bounds(support::classical_of(law["parameters"])).empty());
  }
  EXPECT_TRUE(rheology::neutral_points(rheology::constant(0.4)).empty());
}

TEST(WellPosedness, MissingI_NIsTheLowerNeutralPoint) {
  for (const auto& law : reference_laws()) {
    const auto& p = law["parameters"];
    const auto partial = rheology::partially_regularised(support::classical_of(p), p["mu_inf"], p["alpha"]);
    EXPECT_LT(off(partial.I_N, law["neutral_classical"][0]), 1e-12);
    EXPECT_LT(off(partial.friction(partial.I_N), partial.friction(std::nextafter(partial.I_N, 1.0))), 1e-13);
  }
}

TEST(WellPosedness, ConditionEqualsTheReferenceAtEveryI) {
  for (const auto& law : reference_laws())
    for (const auto& row : law["curves"]) {
      const double I = row["I"];
      const auto classical = rheology::response(support::classical_of(law["parameters"]), I);
      const auto partial = rheology::response(support::partial_of(law["parameters"]), I);
      EXPECT_NEAR(rheology::condition_C(partial), row["C_p"], 1e-12) << I;
      EXPECT_NEAR(rheology::condition_C(classical), row["C_c"], 1e-12) << I;
      EXPECT_LT(off(partial.nu, row["nu_p"]), 1e-12) << I;
      EXPECT_LT(off(classical.q, row["q_c"]), 1e-12) << I;
    }
}

TEST(WellPosedness, GrowthEqualsTheReferenceInEveryDirection) {
  for (const auto& law : reference_laws()) {
    const auto grains = support::grains_of(law["parameters"]);
    int compared = 0;
    for (const auto& row : law["stability"]) {
      const double I = row["I"];
      const auto r = row["law"] == "partial" ? rheology::response(support::partial_of(law["parameters"]), I)
                                             : rheology::response(support::classical_of(law["parameters"]), I);
      EXPECT_LT(off(r.q, row["q"]), 1e-12);
      if (row["max_growth"].is_null()) {
        EXPECT_TRUE(std::isinf(rheology::max_growth(r)));
        continue;
      }
      EXPECT_NEAR(rheology::max_growth(r), row["max_growth"], 1e-12) << I;
      EXPECT_NEAR(rheology::growth_scale(grains, r, I, 1.0 / grains.d) * rheology::max_growth(r),
                  row["sigma_max_over_gamma_per_kd2"], 1e-11 * rheology::growth_scale(grains, r, I, 1.0 / grains.d));
      for (const auto& direction : row["directions"]) {
        const double s = std::sin(2.0 * direction[0].get<double>() * std::numbers::pi / 180.0);
        EXPECT_NEAR(rheology::growth(r, s), direction[1], 1e-12) << I << " " << direction[0];
        ++compared;
      }
    }
    EXPECT_GT(compared, 50);
  }
}

TEST(WellPosedness, MaximumIsTheLargestOverDirectionsAlsoForSteepLaws) {
  // nu above 1 makes the interior extremum a minimum: the largest growth then lies at s = +-1.
  for (const double nu : {-0.2, 0.1, 0.7, 0.99, 1.3})
    for (const double q : {0.2, 0.6, 0.98}) {
      const rheology::Response r{q / (1.0 - 0.5 * nu), nu, q};
      double largest = -1e300;
      for (int i = -20000; i <= 20000; ++i) largest = std::max(largest, rheology::growth(r, i / 20000.0));
      EXPECT_NEAR(rheology::max_growth(r), largest, 1e-7) << nu << " " << q;
    }
}

TEST(WellPosedness, SignOfCDecidesBelowNuOneHalf) {
  const rheology::Law classical = rheology::classical(0.4, 0.9, 1.3);
  for (double I = 1e-4; I < 1e3; I *= 1.1) {
    const auto r = rheology::response(classical, I);
    EXPECT_LT(r.nu, 0.5);
    EXPECT_EQ(rheology::condition_C(r) > 0.0, rheology::max_growth(r) > 0.0) << I;
  }
}
}  // namespace
