#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ida/ida.hpp"
#include "unit/ida_problems.hpp"

namespace talus::test {
namespace {

struct Silent final : core::Observer {};

template <class Model>
struct Journey {
  explicit Journey(const ida::Options& options, Model model = {}, std::vector<double> breakpoints = {})
      : system(std::move(model), std::move(breakpoints)), integrator(system, options) {
    std::vector<double> y(Model::n), yp(Model::n);
    system.initial_state(0.0, y, yp);
    integrator.start(0.0, y, yp);
  }
  core::Snapshot to(double t) {
    EXPECT_TRUE(integrator.advance(t, observer));
    return integrator.current();
  }
  SmallDae<Model> system;
  ida::Ida integrator;
  Silent observer;
};

ida::Options options_with(double rtol, ida::Newton newton = ida::Newton::damped) {
  ida::Options options;
  options.rtol = rtol;
  options.newton.kind = newton;
  return options;
}

struct PendulumError {
  double position = 0.0, multiplier = 0.0;
};

/// The largest errors at twenty times: at a single one an error may happen to pass through zero.
PendulumError pendulum_error(const ida::Options& options) {
  Journey<Pendulum> run(options);
  PendulumError error;
  for (int i = 1; i <= 20; ++i) {
    const double t = 0.1 * i;
    const auto y = run.to(t).y;
    const auto [theta, omega] = pendulum_angle(t);
    error.position = std::max(error.position, std::hypot(y[0] - std::sin(theta), y[1] + std::cos(theta)));
    error.multiplier = std::max(error.multiplier, std::abs(y[4] - (omega * omega + Pendulum::g * std::cos(theta))));
  }
  return error;
}

TEST(IdaPendulum, ErrorFallsWithTheTolerance) {
  for (const auto newton : {ida::Newton::damped, ida::Newton::stock}) {
    const auto coarse = pendulum_error(options_with(1e-3, newton));
    const auto middle = pendulum_error(options_with(1e-5, newton));
    const auto fine = pendulum_error(options_with(1e-7, newton));
    EXPECT_LT(coarse.position, 3e-2);
    EXPECT_LT(middle.position, 0.1 * coarse.position);
    EXPECT_LT(fine.position, 0.2 * middle.position);
    EXPECT_LT(fine.position, 5e-6);
    EXPECT_LT(middle.multiplier, 0.2 * coarse.multiplier);
    EXPECT_LT(fine.multiplier, 0.5 * middle.multiplier);
    EXPECT_LT(fine.multiplier, 2e-3);
  }
}

TEST(IdaStart, PendulumWithAnInconsistentVelocityIsProjected) {
  Pendulum model;
  const double c = std::cos(0.3), s = std::sin(0.3);
  model.y_0 = {c, s, 0.5 * c - 0.2 * s, 0.5 * s + 0.2 * c, 17.0};  // 0.5 along the rod, 0.2 across
  Journey<Pendulum> run(options_with(1e-6), model);
  const auto now = run.integrator.current();
  EXPECT_DOUBLE_EQ(now.t, 0.0);
  EXPECT_NEAR(now.y[0], c, 1e-6);
  EXPECT_NEAR(now.y[1], s, 1e-6);
  EXPECT_NEAR(now.y[2], -0.2 * s, 1e-5);
  EXPECT_NEAR(now.y[3], 0.2 * c, 1e-5);
  const double lambda = 0.04 - Pendulum::g * s;
  EXPECT_NEAR(now.y[4], lambda, 1e-4);
  EXPECT_NEAR(now.yp[2], -lambda * c, 1e-4);
  EXPECT_NEAR(now.yp[3], -lambda * s - Pendulum::g, 1e-4);
}

TEST(IdaStart, ConstraintsThatMoveGiveTheirRateToTheDerivative) {
  Tied model;
  model.q = [](double t) { return 1.0 + 3.0 * t; };  // u1 + u2 = 1 at the start, growing by 3 a second
  Journey<Tied> run(options_with(1e-6), model);
  const auto now = run.integrator.current();
  EXPECT_NEAR(now.y[2], 0.5 * (3.0 + 2.0), 1e-5);
  EXPECT_NEAR(now.yp[0] + now.yp[1], 3.0, 1e-5);
  EXPECT_NEAR(now.yp[0] - now.yp[1], -2.0 * 0.4, 1e-5);
}

/// A slow and a fast unknown, neither constrained, begun apart.
struct SlowAndFast {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, differential};
  std::array<double, n> tolerances = {1e-8, 1e-8};
  std::array<double, n> y_0 = {1.0, 0.5}, yp_0 = {};

  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] + y[0], yp[1] + 1e6 * (y[1] - y[0])};
  }
};

TEST(IdaStart, WithoutConstraintsTheStateIsKeptBitForBit) {
  Journey<SlowAndFast> run(options_with(1e-6));
  const auto start = run.integrator.current();
  EXPECT_EQ(start.y[0], 1.0);
  EXPECT_EQ(start.y[1], 0.5);
  const auto end = run.to(1.0);
  EXPECT_NEAR(end.y[0], std::exp(-1.0), 1e-5);
  EXPECT_NEAR(end.y[1], std::exp(-1.0), 1e-5);
}

/// c + c^3 = 2 sin t, with a tolerance under which its error does not count.
struct Cubic {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, algebraic};
  std::array<double, n> tolerances = {1e-3, 1e3}, bounds = {HUGE_VAL, HUGE_VAL};
  std::array<double, n> y_0 = {}, yp_0 = {};

  template <class S>
  std::array<S, n> residual(double t, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] - std::cos(t), y[1] + y[1] * y[1] * y[1] - 2.0 * std::sin(t)};
  }
};

/// The largest error of c at the end of a step.
struct WorstCubic final : core::Observer {
  double error = 0.0;
  bool on_step(const core::Snapshot& now) override {
    error = std::max(error, std::abs(now.y[1] + std::pow(now.y[1], 3) - 2.0 * std::sin(now.t)));
    return true;
  }
};

TEST(IdaSolution, ABoundHoldsForItsUnknownWhateverTheToleranceSays) {
  const auto error = [](double bound) {
    Cubic model;
    model.bounds[1] = bound;
    Journey<Cubic> run(options_with(1e-3), model);
    WorstCubic worst;
    EXPECT_TRUE(run.integrator.advance(3.0, worst));
    return worst.error;
  };
  EXPECT_GT(error(HUGE_VAL), 1e-4);
  EXPECT_LT(error(1e-8), 1e-7);
}

TEST(IdaSolution, LinearSaddlePointFollowsItsExactSolution) {
  Journey<Tied> run(options_with(1e-7));
  for (const double t : {0.1, 1.0, 3.0}) {
    const auto now = run.to(t);
    EXPECT_NEAR(now.y[0] + now.y[1], std::sin(t), 1e-6);
    EXPECT_NEAR(now.y[0] - now.y[1], 0.4 * std::exp(-2.0 * t), 1e-5);
    EXPECT_NEAR(now.y[2], 0.5 * (std::cos(t) + 2.0 * std::sin(t)), 1e-4);
  }
}

TEST(IdaSolution, RobertsonMeetsThePublishedValues) {
  Journey<Robertson> run(options_with(1e-7));
  const auto early = run.to(0.4);
  EXPECT_NEAR(early.y[0], 9.8517e-1, 1e-5);
  EXPECT_NEAR(early.y[1], 3.3864e-5, 1e-9);
  const auto late = run.to(4e7);
  EXPECT_NEAR(late.y[0], 5.203e-5, 3e-8);
  EXPECT_NEAR(late.y[0] + late.y[1] + late.y[2], 1.0, 1e-12);
}

}  // namespace
}  // namespace talus::test
