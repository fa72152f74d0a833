#include <gtest/gtest.h>

#include "core/scalar.hpp"

namespace {
using talus::core::Dual;
using talus::core::Trace;

template <class S>
S sample(const S& a, const S& b) {
  using namespace talus::core;
  using std::exp;
  using std::log;
  using std::sqrt;
  using std::tanh;
  using std::pow;
  return sqrt(a * a + 2.0) / (1.0 + b) - tanh(a / b) * exp(-b) + log(a + b) * pow(b, 1.5) - 3.0 / a;
}

TEST(Dual, AgreesWithCentralDifferences) {
  const double a = 0.7, b = 1.3, h = 1e-6;
  const auto r = sample(Dual<2>::input(a, 0), Dual<2>::input(b, 1));
  EXPECT_DOUBLE_EQ(r.value, sample(a, b));
  EXPECT_NEAR(r.slope[0], (sample(a + h, b) - sample(a - h, b)) / (2 * h), 1e-8);
  EXPECT_NEAR(r.slope[1], (sample(a, b + h) - sample(a, b - h)) / (2 * h), 1e-8);
}

TEST(Trace, UnitesBothBranches) {
  using T = Trace<3>;
  const T r = talus::core::select_above(
      T::input(0), 0.0, [] { return T::input(1); }, [] { return T::input(2); });
  EXPECT_EQ(r.inputs.count(), 3U);
  EXPECT_EQ((T::input(1) * 2.0 + T(4.0)).inputs, T::input(1).inputs);
}
}  // namespace
