#include <gtest/gtest.h>

#include "core/scalar.hpp"

namespace {
using talus::core::Dual;
using talus::core::Pack;
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

TEST(Pack, GivesEachLaneTheBitsOfADouble) {
  const double a[]{0.7, 2.0, 1e-3, 40.0}, b[]{1.3, 0.01, 5.0, 3.0};
  const Pack r = sample(Pack::at(a), Pack::at(b));
  for (int lane = 0; lane < Pack::lanes; ++lane) EXPECT_EQ(r.lane[lane], sample(a[lane], b[lane]));
}

TEST(Pack, TakesEachLaneFromItsOwnBranch) {
  const auto above = [](const Pack& x) {
    return talus::core::select_above(
        x, 1.0, [&] { return Pack(x * 10.0); }, [] { return Pack(-1.0); });
  };
  EXPECT_EQ(above({2.0, 3.0, 4.0, 5.0}).lane, (std::array{20.0, 30.0, 40.0, 50.0}));
  EXPECT_EQ(above({0.0, 1.0, -4.0, 0.5}).lane, (std::array{-1.0, -1.0, -1.0, -1.0}));
  EXPECT_EQ(above({0.0, 3.0, 1.0, 5.0}).lane, (std::array{-1.0, 30.0, -1.0, 50.0}));
}

TEST(Trace, UnitesBothBranches) {
  using T = Trace<3>;
  const T r = talus::core::select_above(
      T::input(0), 0.0, [] { return T::input(1); }, [] { return T::input(2); });
  EXPECT_EQ(r.inputs.count(), 3U);
  EXPECT_EQ((T::input(1) * 2.0 + T(4.0)).inputs, T::input(1).inputs);
}
}  // namespace
