#include "arkode/arkode.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/errors.hpp"
#include "unit/ida_problems.hpp"

namespace talus::test {
namespace {

struct Silent final : core::Observer {};

/// 2 y0' + 2 y1 = 0, 3 y1' - 3 y0 = 0: a circle.
struct Circle {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds{differential, differential};
  std::array<double, n> tolerances{1e-12, 1e-12}, y_0{1.0, 0.0}, yp_0{};
  bool crossed = false;  // each row holds the rate of the other unknown
  template <class S>
  std::array<S, n> residual(double /*t*/, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    if (crossed) return {S(yp[1] - y[0]), S(yp[0] + y[1])};
    return {S(2.0 * yp[0] + 2.0 * y[1]), S(3.0 * yp[1] - 3.0 * y[0])};
  }
};

TEST(Arkode, FollowsACircleToItsToleranceAndStopsWhereAsked) {
  const SmallDae<Circle> system({}, {1.0});
  for (const double rtol : {1e-4, 1e-6, 1e-8}) {
    arkode::Arkode integrator(system, {.rtol = rtol});
    integrator.start(0.0, std::array{1.0, 0.0}, std::array{0.0, 0.0});
    Silent observer;
    ASSERT_TRUE(integrator.advance(0.5, observer));
    ASSERT_TRUE(integrator.advance(3.0, observer));
    const auto end = integrator.current();
    EXPECT_EQ(end.t, 3.0);
    EXPECT_NEAR(end.y[0], std::cos(3.0), 20.0 * rtol);
    EXPECT_NEAR(end.y[1], std::sin(3.0), 20.0 * rtol);
    EXPECT_NEAR(end.yp[0], -end.y[1], 1e-14);
    EXPECT_GT(end.statistics.steps, 3);
  }
}

TEST(Arkode, MakesOnlyTheStepsThatAreAllowed) {
  const SmallDae<Circle> system{{}};
  arkode::Arkode integrator(system, {.rtol = 1e-8, .max_steps = 5});
  integrator.start(0.0, std::array{1.0, 0.0}, std::array{0.0, 0.0});
  Silent observer;
  EXPECT_THROW(integrator.advance(3.0, observer), core::IntegrationError);
}

TEST(Arkode, RefusesConstraintsAndRatesInRowsOfOthers) {
  const SmallDae<Pendulum> pendulum{{}};
  EXPECT_THROW(arkode::Arkode{pendulum}, std::invalid_argument);
  const SmallDae<Circle> crossed{{.crossed = true}};
  EXPECT_THROW(arkode::Arkode{crossed}, std::invalid_argument);
  const SmallDae<Circle> circle{{}};
  EXPECT_THROW((arkode::Arkode{circle, {.order = 9}}), std::invalid_argument);
}

}  // namespace
}  // namespace talus::test
