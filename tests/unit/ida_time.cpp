#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ida/ida.hpp"
#include "unit/ida_problems.hpp"

namespace talus::test {
namespace {

/// Keeps the times it sees; stops from `stop_at` on.
struct Recorder final : core::Observer {
  std::vector<double> times;
  double stop_at = HUGE_VAL;
  bool on_step(const core::Snapshot& now) override {
    times.push_back(now.t);
    return now.t < stop_at;
  }
};

/// u1 + u2 = q with q growing by 1 a second up to t = 1, then constant: p jumps by -1/2 there.
Tied kinked() {
  Tied model;
  model.q = [](double t) { return 1.0 + std::min(t, 1.0); };
  return model;
}

template <class Model>
void begin(ida::Ida& integrator, const SmallDae<Model>& system) {
  std::vector<double> y(Model::n), yp(Model::n);
  system.initial_state(0.0, y, yp);
  integrator.start(0.0, y, yp);
}

ida::Options tight() {
  ida::Options options;
  options.rtol = 1e-7;
  return options;
}

TEST(IdaTime, OutputTimesAreExactAndDoNotDisturbTheSteps) {
  const SmallDae<Tied> system;
  ida::Ida plain(system, tight()), watched(system, tight());
  Recorder few, many;
  begin(plain, system);
  begin(watched, system);
  EXPECT_TRUE(plain.advance(1.0, few));
  // The first step depends on the first output time asked for; from there on outputs must not matter.
  EXPECT_TRUE(watched.advance(1.0, many));
  for (int i = 1; i <= 100; ++i) {
    const double t = 1.0 + 0.02 * i;
    EXPECT_TRUE(watched.advance(t, many));
    const auto now = watched.current();
    EXPECT_EQ(now.t, t);
    EXPECT_NEAR(now.y[0] + now.y[1], std::sin(t), 1e-6);
    EXPECT_NEAR(now.yp[0] + now.yp[1], std::cos(t), 1e-4);
    EXPECT_LE(many.times.back(), t);
  }
  EXPECT_TRUE(plain.advance(3.0, few));
  EXPECT_EQ(few.times, many.times);
  EXPECT_TRUE(std::is_sorted(many.times.begin(), many.times.end()));
  EXPECT_TRUE(std::equal(plain.current().y.begin(), plain.current().y.end(), watched.current().y.begin()));
}

TEST(IdaTime, StopsAtAKinkAndStartsAfresh) {
  const SmallDae<Tied> system(kinked(), {1.0});
  ida::Ida integrator(system, tight());
  Recorder seen;
  begin(integrator, system);
  EXPECT_TRUE(integrator.advance(2.5, seen));
  EXPECT_EQ(std::count(seen.times.begin(), seen.times.end(), 1.0), 1);
  const auto now = integrator.current();
  EXPECT_EQ(now.statistics.restarts, 1);
  EXPECT_EQ(now.statistics.newton_failures, 0);
  EXPECT_NEAR(now.y[0] + now.y[1], 2.0, 1e-9);
  EXPECT_NEAR(now.y[2], 2.0, 1e-6);  // (q' + k q)/2 = k
  EXPECT_NEAR(now.y[0] - now.y[1], 0.4 * std::exp(-5.0), 1e-5);
}

TEST(IdaTime, AKinkAtAnOutputTimeIsSeenFromTheLeftThenCrossed) {
  const SmallDae<Tied> system(kinked(), {1.0});
  ida::Ida integrator(system, tight());
  Recorder seen;
  begin(integrator, system);
  EXPECT_TRUE(integrator.advance(1.0, seen));
  EXPECT_EQ(integrator.current().t, 1.0);
  EXPECT_NEAR(integrator.current().y[2], 2.5, 1e-5);  // q' = 1 still
  EXPECT_EQ(integrator.current().statistics.restarts, 0);
  EXPECT_TRUE(integrator.advance(1.0 + 1e-3, seen));
  EXPECT_NEAR(integrator.current().y[2], 2.0, 1e-5);
  EXPECT_EQ(integrator.current().statistics.restarts, 1);
}

TEST(IdaTime, BreakpointsThatArePastOrAtTheStartAreIgnored) {
  const SmallDae<Tied> system(kinked(), {-1.0, 0.0, 1.0, 7.0});
  ida::Ida integrator(system, tight());
  Recorder seen;
  begin(integrator, system);
  EXPECT_TRUE(integrator.advance(3.0, seen));
  EXPECT_EQ(integrator.current().statistics.restarts, 1);
}

TEST(IdaTime, AnObserverMayStopTheRunAndGoOnLater) {
  const SmallDae<Tied> system;
  ida::Ida integrator(system, tight());
  Recorder seen;
  seen.stop_at = 0.5;
  begin(integrator, system);
  EXPECT_FALSE(integrator.advance(1.0, seen));
  const double stopped = integrator.current().t;
  EXPECT_GE(stopped, 0.5);
  EXPECT_LT(stopped, 1.0);
  EXPECT_EQ(stopped, seen.times.back());
  seen.stop_at = HUGE_VAL;
  EXPECT_TRUE(integrator.advance(1.0, seen));
  EXPECT_EQ(integrator.current().t, 1.0);
}

TEST(IdaTime, ARestartEqualsAFreshStartBitByBit) {
  const SmallDae<Pendulum> system;
  ida::Ida continued(system), fresh(system);
  Recorder seen;
  begin(continued, system);
  EXPECT_TRUE(continued.advance(0.7, seen));
  const auto checkpoint = continued.current();
  const std::vector<double> y(checkpoint.y.begin(), checkpoint.y.end()), yp(checkpoint.yp.begin(), checkpoint.yp.end());
  const auto steps = checkpoint.statistics.steps;
  continued.restart();
  EXPECT_GE(continued.current().statistics.steps, steps);
  EXPECT_TRUE(continued.advance(1.5, seen));
  fresh.start(0.7, y, yp);
  EXPECT_TRUE(fresh.advance(1.5, seen));
  for (int i = 0; i < Pendulum::n; ++i) EXPECT_EQ(continued.current().y[i], fresh.current().y[i]);
  EXPECT_GT(continued.current().statistics.steps, fresh.current().statistics.steps);
}

TEST(IdaTime, StatisticsAddUpOverRestarts) {
  const SmallDae<Tied> system(kinked(), {1.0});
  ida::Ida integrator(system, tight());
  Recorder seen;
  begin(integrator, system);
  EXPECT_TRUE(integrator.advance(3.0, seen));
  const auto& s = integrator.current().statistics;
  EXPECT_GE(s.steps, static_cast<std::int64_t>(seen.times.size()));
  EXPECT_LE(s.steps, static_cast<std::int64_t>(seen.times.size()) + 1);  // one may end beyond the last output
  EXPECT_GT(s.newton_iterations, s.steps / 2);
  EXPECT_GE(s.residuals, s.newton_iterations);
  EXPECT_EQ(s.jacobians, s.factorisations);
  EXPECT_GE(s.solves, s.newton_iterations);
  EXPECT_LT(s.factorisations, s.steps);
  EXPECT_GE(s.order, 1);
  EXPECT_GT(s.last_step, 0.0);
}

TEST(IdaTime, RefusesToGoBackAndToRunUnstarted) {
  const SmallDae<Tied> system;
  ida::Ida integrator(system);
  Recorder seen;
  EXPECT_THROW(integrator.advance(1.0, seen), std::logic_error);
  EXPECT_THROW(integrator.restart(), std::logic_error);
  begin(integrator, system);
  EXPECT_TRUE(integrator.advance(0.5, seen));
  EXPECT_THROW(integrator.advance(0.4, seen), std::invalid_argument);
  const std::vector<double> two(2);
  EXPECT_THROW(integrator.start(0.0, two, two), std::invalid_argument);
}

}  // namespace
}  // namespace talus::test
