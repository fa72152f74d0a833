#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/dual.hpp"
#include "fv/sharp_transport.hpp"

namespace {

using namespace talus;

/// Between giver and taker, and at an extremum the giver's own.
TEST(SharpTransport, TheLimiterMakesNoNewExtremum) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0), ratio(0.4, 1.8);
  int steepened = 0;
  for (int n = 0; n < 20000; ++n) {
    const double before = share(random), giver = share(random), taker = share(random);
    const double face = fv::limited(before, giver, taker, ratio(random), ratio(random));
    ASSERT_GE(face, std::fmin(giver, taker));
    ASSERT_LE(face, std::fmax(giver, taker));
    if ((giver - before) * (taker - giver) <= 0.0) EXPECT_EQ(face, giver);
    else ++steepened;
  }
  EXPECT_GT(steepened, 5000);
}

TEST(SharpTransport, TheLimiterIsOfSecondOrderWherePhiIsSmooth) {
  const auto error = [](double h) {
    const auto phi = [](double x) { return 0.5 + 0.3 * std::sin(x); };
    const auto mean = [&](double x) { return 0.5 + 0.3 * (std::cos(x - 0.5 * h) - std::cos(x + 0.5 * h)) / h; };
    return std::abs(fv::limited(mean(0.5 - h), mean(0.5), mean(0.5 + h), 1.0, 1.0) - phi(0.5 + 0.5 * h));
  };
  EXPECT_NEAR(std::log2(error(0.01) / error(0.005)), 2.0, 0.15);
}

/// A derivative that jumps would show as a difference that does not fall with the step.
TEST(SharpTransport, HasContinuousDerivatives) {
  const auto slopes = [](double giver, double taker) {
    using Dual = core::Dual<3>;
    return fv::limited(Dual::input(0.2, 0), Dual::input(giver, 1), Dual::input(taker, 2), 1.0, 1.0).slope;
  };
  for (const double taker : {0.0, 0.2, 0.5, 0.9}) {
    for (const double giver : {0.2, taker}) {  // where one of the two differences changes sign
      const auto below = slopes(giver - 1e-9, taker), above = slopes(giver + 1e-9, taker);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(below[i], above[i], 1e-4) << giver << " " << taker;
    }
  }
  const auto onset = [](double x) { return fv::above_zero(core::Dual<1>::input(x, 0)).slope[0]; };
  EXPECT_NEAR(onset(-1e-10), onset(1e-10), 1e-5);
  const auto through_zero = [](double x) { return fv::not_less(core::Dual<1>::input(x, 0)).slope[0]; };
  EXPECT_NEAR(through_zero(-1e-10), through_zero(1e-10), 1e-5);
}

TEST(SharpTransport, NothingPartsFromWhatIsEmptyOrIntoWhatIsFull) {
  for (const double other : {-0.1, 0.0, 0.3, 1.0, 1.1}) {
    EXPECT_EQ(fv::parting(0.0, other), 0.0);
    EXPECT_EQ(fv::parting(other, 1.0), 0.0);
  }
  EXPECT_EQ(fv::parting(0.5, 0.5), 0.25);
}

/// What errors of iteration have put out of bounds comes back, by little: no runaway, however far out both cells are.
TEST(SharpTransport, WhatIsOutOfBoundsIsNotDrivenFurther) {
  for (const double out : {1e-7, 1e-3, 0.3, 30.0}) {
    for (const double other : {0.0, 0.4, 0.999}) {
      EXPECT_LT(fv::parting(-out, other), 0.0);             // to the empty giver
      EXPECT_LT(fv::parting(1.0 - other, 1.0 + out), 0.0);  // from the full taker
      EXPECT_GT(fv::parting(-out, other), -1e-3);
    }
    EXPECT_GE(fv::parting(-out, 1.0 + out), 0.0);
    EXPECT_LT(fv::parting(-out, 1.0 + out), 1e-6);
  }
}

/// The derivative by either cell never changes its sign within the bounds, nor beyond them while the other cell keeps to them.
TEST(SharpTransport, PartingIsMonotone) {
  using Dual = core::Dual<2>;
  for (double giver = -0.5; giver <= 1.5; giver += 0.01) {
    for (double taker = -0.5; taker <= 1.5; taker += 0.01) {
      const auto slope = fv::parting(Dual::input(giver, 0), Dual::input(taker, 1)).slope;
      EXPECT_TRUE(taker > 1.0 || slope[0] >= 0.0) << giver << ' ' << taker;
      EXPECT_TRUE(giver < 0.0 || slope[1] <= 0.0) << giver << ' ' << taker;
    }
  }
}

TEST(SharpTransport, AFluxTakesWhatTheGiverHas) {
  EXPECT_NEAR(fv::upwind_flux(2.0, 1e-7, 0.3, 0.8), 0.6, 1e-9);
  EXPECT_NEAR(fv::upwind_flux(-2.0, 1e-7, 0.3, 0.8), -1.6, 1e-9);
  EXPECT_NEAR(fv::upwind_value(-2.0, 1e-7, 0.3, 0.8), 0.8, 1e-9);
  EXPECT_EQ(fv::upwind_value(0.0, 1e-7, 0.3, 0.8), 0.55);
}

}  // namespace
