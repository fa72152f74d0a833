#include <gtest/gtest.h>

#include <cmath>

#include "rheology/neutral_points.hpp"
#include "rheology/parameter_slopes.hpp"
#include "rheology/well_posedness.hpp"

/// Derivatives by parameters against central differences of the laws themselves.
namespace {
using namespace talus::rheology;

using Numbers = ByLawParameter<double>;
const Numbers table_2{0.4, 0.9, 1.3, 1.3, 1.9, 0.05178};

Law partial_of(const Numbers& v) { return partially_regularised(classical(v[0], v[1], v[3]), v[2], v[4], v[5]); }
Law classical_of(const Numbers& v) { return classical(v[0], v[1], v[3]); }

/// Fourth order in the step.
template <class F>
double difference(F&& f, Numbers v, int i) {
  const double h = 1e-4 * v[i], middle = v[i];
  const auto at = [&](double shift) { return v[i] = middle + shift, f(v); };
  return (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
}

class ParameterSlopes : public testing::TestWithParam<double> {};

TEST_P(ParameterSlopes, AreThoseOfTheLaw) {
  const double I = GetParam();
  for (Law (*make)(const Numbers&) : {partial_of, classical_of}) {
    const auto slopes = parameter_slopes(make(table_2), I);
    const auto posed = posedness_slopes(make(table_2), I);
    for (int i = 0; i < n_law_parameters; ++i) {
      SCOPED_TRACE(i);
      const double friction_slope = difference([&](const Numbers& v) { return friction(make(v), I); }, table_2, i);
      const auto C = [&](const Numbers& v) { return condition_C(response(make(v), I)); };
      const auto q = [&](const Numbers& v) { return response(make(v), I).q; };
      EXPECT_NEAR(slopes[i], friction_slope, 1e-9);
      EXPECT_NEAR(posed.C[i], difference(C, table_2, i), 1e-8);
      EXPECT_NEAR(posed.q[i], difference(q, table_2, i), 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(CreepAndRational, ParameterSlopes, testing::Values(1e-12, 1e-4, 0.04, 0.06, 0.5, 1.7, 20.0));

TEST(ParameterSlopes, OfTheNeutralPointAreThoseOfItsRoot) {
  const auto I_N = [](const Numbers& v) { return neutral_points(classical_of(v)).front(); };
  const Classical base = classical(table_2[0], table_2[1], table_2[3]);
  const auto slopes = neutral_point_slopes(base, I_N(table_2));
  for (int i = 0; i < n_law_parameters; ++i) EXPECT_NEAR(slopes[i], difference(I_N, table_2, i), 1e-8) << i;
  EXPECT_NEAR(slopes[3], I_N(table_2) / table_2[3], 1e-12);  // I_N scales with I_0
}
}  // namespace
