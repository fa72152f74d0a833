#include "rheology/viscosity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {
using namespace talus;
using core::Dual;
using rheology::Cap;
using rheology::Law;
using rheology::Regularisation;

const rheology::Grains grains = rheology::grains(2500.0, 0.6, 0.00073);
const rheology::Classical base = rheology::classical(0.4, 0.9, 1.3);
const std::vector<Law> every_law{base, rheology::partially_regularised(base, 1.3, 1.9, 0.05178),
                                 rheology::constant(0.4)};

template <class S>
S stress(const Law& law, const Regularisation& reg, const S& shear, const S& floor, const S& p) {
  return rheology::viscosity(law, grains, reg, S(0.25 * shear * shear), floor, p) * shear;
}

/// Shear rate [1/s] at which I = I_target under pressure p [Pa].
double shear_of(double I, double p) { return I * std::sqrt(p / grains.rho_star) / grains.d; }

/// Fourth-order central difference.
template <class F>
double difference(F&& f, double x, double h) {
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

struct Point {
  double shear, floor, p;
};

void expect_exact_derivatives(const Law& law, const Regularisation& reg, const Point& a) {
  const auto r = stress(law, reg, Dual<7>::input(a.shear, 1), Dual<7>::input(a.floor, 4), Dual<7>::input(a.p, 6));
  EXPECT_DOUBLE_EQ(r.value, stress(law, reg, a.shear, a.floor, a.p));
  const double by_shear =
      difference([&](double x) { return stress(law, reg, x, a.floor, a.p); }, a.shear, 1e-3 * a.shear);
  const double by_floor =
      difference([&](double x) { return stress(law, reg, a.shear, x, a.p); }, a.floor, 1e-3 * a.floor);
  const double by_p = difference([&](double x) { return stress(law, reg, a.shear, a.floor, x); }, a.p,
                                 1e-3 * std::max(std::abs(a.p), reg.p_0));
  const double size = std::abs(r.value);
  EXPECT_NEAR(r.slope[1] * a.shear, by_shear * a.shear, 1e-9 * size) << rheology::name(law) << " shear " << a.shear;
  EXPECT_NEAR(r.slope[4] * a.floor, by_floor * a.floor, 1e-9 * size) << rheology::name(law) << " floor " << a.floor;
  EXPECT_NEAR(r.slope[6] * a.p, by_p * a.p, 1e-9 * size) << rheology::name(law) << " p " << a.p;
  EXPECT_EQ(r.slope[0], 0.0);
}

TEST(Viscosity, DerivativesAreExactOverTheWholeRangeOfI) {
  const Regularisation plain{}, smooth{1.0, 0.0, 0.0, 1e3, Cap::smooth}, hard{1.0, 0.0, 0.0, 1e3, Cap::hard};
  for (const Law& law : every_law)
    for (const double p : {3.0, 100.0, 2e4})
      for (const double I : {1e-9, 1e-4, 0.051, 0.053, 0.5, 20.0}) {
        const Point a{shear_of(I, p), 0.1 * shear_of(I, p), p};
        expect_exact_derivatives(law, plain, a);
        expect_exact_derivatives(law, smooth, a);
        expect_exact_derivatives(law, hard, a);
      }
}

TEST(Viscosity, DerivativesAreExactAtZeroAndNegativePressure) {
  const Regularisation reg{5.0, 0.0, 0.0, 1e3, Cap::smooth};
  for (const Law& law : every_law)
    for (const double p : {1.0, 0.0, -1.0, -300.0}) expect_exact_derivatives(law, reg, {2.0, 0.01, p});
}

TEST(Viscosity, DerivativeOfTheStressAtRestIsTheRestingViscosity) {
  for (const Law& law : every_law)
    for (const auto& [reg, floor] : {std::pair{Regularisation{1.0, 0.0, 0.0, 1e4, Cap::smooth}, 0.0},
                                     std::pair{Regularisation{}, 1e-3}, std::pair{Regularisation{}, 0.0}}) {
      const auto r = stress(law, reg, Dual<2>::input(0.0, 0), Dual<2>(floor), Dual<2>::input(50.0, 1));
      EXPECT_EQ(r.value, 0.0);
      EXPECT_EQ(r.slope[1], 0.0);
      const double rate = std::max(floor, rheology::tiny_rate);
      const double central = difference([&](double x) { return stress(law, reg, x, floor, 50.0); }, 0.0, 1e-5 * rate);
      EXPECT_NEAR(r.slope[0] / central, 1.0, 1e-8) << rheology::name(law);
    }
}

TEST(Viscosity, IsFiniteWithFiniteDerivativesEverywhere) {
  const std::vector<Regularisation> switches{
      {}, {1.0, 1e-6, 0.0, 1e4, Cap::smooth}, {0.0, 0.0, 0.0, 1e4, Cap::hard}, {1e-3, 0.0, 1e-3, 1e9, Cap::smooth}};
  for (const Law& law : every_law)
    for (const auto& reg : switches)
      for (const double shear : {0.0, 1e-14, 1e-3, 10.0, 1e6})
        for (const double p : {-1e5, -1.0, 0.0, 1e-12, 1.0, 1e6}) {
          const auto r = stress(law, reg, Dual<3>::input(shear, 0), Dual<3>::input(0.0, 1), Dual<3>::input(p, 2));
          EXPECT_TRUE(std::isfinite(r.value) && std::isfinite(r.slope[0]) && std::isfinite(r.slope[1]) &&
                      std::isfinite(r.slope[2]))
              << rheology::name(law) << " shear " << shear << " p " << p;
          EXPECT_GE(r.value, 0.0);
        }
}

TEST(Viscosity, CapsBoundItAndVanishFarBelow) {
  const Regularisation none{}, smooth{0.0, 0.0, 0.0, 10.0, Cap::smooth}, hard{0.0, 0.0, 0.0, 10.0, Cap::hard};
  const auto eta = [](const Regularisation& reg, double shear) {
    return rheology::viscosity(every_law[1], grains, reg, 0.25 * shear * shear, 0.0, 100.0);
  };
  EXPECT_EQ(eta(hard, 1e-6), 10.0);
  EXPECT_EQ(eta(hard, 1e3), eta(none, 1e3));
  EXPECT_NEAR(eta(smooth, 1e-6), 10.0, 1e-9);
  for (const double shear : {1.0, 5.0, 9.0, 1e3}) {
    EXPECT_LT(eta(smooth, shear), std::min(10.0, eta(none, shear)));
    EXPECT_NEAR(eta(smooth, shear), 1.0 / std::hypot(1.0 / eta(none, shear), 0.1), 1e-12);
  }
}

TEST(Viscosity, PositivePressureIsPositiveAndDoesNotCancel) {
  EXPECT_EQ(rheology::positive_pressure(-3.0, 0.0), 0.0);
  EXPECT_EQ(rheology::positive_pressure(3.0, 0.0), 3.0);
  EXPECT_DOUBLE_EQ(rheology::positive_pressure(0.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(rheology::positive_pressure(-1e9, 1.0), 0.25e-9);
  const auto at_zero = rheology::positive_pressure(Dual<1>::input(0.0, 0), 2.0);
  EXPECT_DOUBLE_EQ(at_zero.slope[0], 0.5);
}

TEST(Viscosity, InertialNumberIsTheOneInsideTheFriction) {
  const Regularisation reg{2.0, 0.0, 0.0, 1.0, Cap::none};
  const double D2 = 9.0, floor = 4.0, p = 30.0;
  const double I = rheology::inertial_number(grains, reg, D2, floor, p);
  EXPECT_DOUBLE_EQ(I, 2.0 * grains.d * 5.0 / std::sqrt(rheology::positive_pressure(p, 2.0) / grains.rho_star));
  EXPECT_DOUBLE_EQ(rheology::viscosity(every_law[1], grains, reg, D2, floor, p),
                   rheology::friction(every_law[1], I) * rheology::positive_pressure(p, 2.0) / 10.0);
}

TEST(Viscosity, TracesDependOnAllThreeInputs) {
  using T = core::Trace<3>;
  for (const Cap cap : {Cap::none, Cap::hard, Cap::smooth}) {
    const T r = rheology::viscosity(every_law[1], grains, Regularisation{1.0, 0.0, 0.0, 1e4, cap}, T::input(0),
                                    T::input(1), T::input(2));
    EXPECT_EQ(r.inputs.count(), 3U);
  }
}

TEST(Viscosity, BadRegularisationIsRefused) {
  EXPECT_NO_THROW(rheology::check(Regularisation{}));
  EXPECT_THROW(rheology::check(Regularisation{-1.0}), std::invalid_argument);
  EXPECT_THROW(rheology::check(Regularisation{0.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(rheology::check(Regularisation{0.0, 0.0, 0.0, 0.0, Cap::hard}), std::invalid_argument);
  EXPECT_THROW(rheology::check((Regularisation{.cap = Cap::smooth})), std::invalid_argument);
}
}  // namespace
