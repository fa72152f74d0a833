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

/// What a checkpoint keeps of an integrator.
struct Kept {
  explicit Kept(const ida::Ida& integrator)
      : t(integrator.current().t),
        y(integrator.current().y.begin(), integrator.current().y.end()),
        yp(integrator.current().yp.begin(), integrator.current().yp.end()),
        statistics(integrator.current().statistics),
        linear_solver(integrator.linear_solver()) {}
  [[nodiscard]] core::Snapshot snapshot() const { return {t, y, yp, statistics}; }

  double t;
  std::vector<double> y, yp;
  core::Statistics statistics;
  std::string linear_solver;
};

/// y' = k (cos t/100 - z), y = 2 z + sin t/30 with k growing from 1e3 to 1e9 per second in 1000 s: KLU's first pivots are on
/// the diagonal if it starts at 0 s and beside it if it starts at 1000 s, and give other bits.
struct PivotsMove {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, algebraic};
  std::array<double, n> tolerances = {1e-8, 1e-8}, y_0 = {2.0, 1.0}, yp_0 = {};
  template <class S>
  std::array<S, n> residual(double t, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    const double k = 1e3 * std::exp(0.0138 * t);
    return {yp[0] + k * y[1] - k * std::cos(0.01 * t), y[0] - 2.0 * y[1] - std::sin(t / 30.0)};
  }
};

class IdaCheckpoint : public testing::TestWithParam<linear::Choice> {};

template <class Model>
void expect_equal_bits_after_a_checkpoint(linear::Choice choice, double at, std::vector<double> later) {
  const SmallDae<Model> system;
  ida::Options options;
  options.linear.choice = choice;
  ida::Ida writer(system, options), reader(system, options);
  Recorder seen;
  begin(writer, system);
  EXPECT_TRUE(writer.advance(at, seen));
  const Kept kept(writer);
  writer.resume(kept.snapshot(), kept.linear_solver);
  reader.resume(kept.snapshot(), kept.linear_solver);
  for (const double t : later) {
    EXPECT_TRUE(writer.advance(t, seen));
    EXPECT_TRUE(reader.advance(t, seen));
    const auto a = writer.current(), b = reader.current();
    EXPECT_TRUE(std::ranges::equal(a.y, b.y) && std::ranges::equal(a.yp, b.yp)) << "t = " << t;
    EXPECT_EQ(a.statistics.steps, b.statistics.steps);
    EXPECT_EQ(a.statistics.factorisations, b.statistics.factorisations);
    EXPECT_EQ(a.statistics.last_step, b.statistics.last_step);
  }
  EXPECT_EQ(reader.current().statistics.restarts, 1);
  EXPECT_EQ(writer.linear_solver(), reader.linear_solver());
}

TEST_P(IdaCheckpoint, ARunContinuedFromItEqualsTheRunThatWroteItBitByBit) {
  expect_equal_bits_after_a_checkpoint<Pendulum>(GetParam(), 0.7, {0.8, 1.1, 3.0});
  expect_equal_bits_after_a_checkpoint<PivotsMove>(GetParam(), 1000.0, {1000.5, 1100.0, 3000.0});
}

INSTANTIATE_TEST_SUITE_P(EachLinearSolver, IdaCheckpoint,
                         testing::Values(linear::Choice::automatic, linear::Choice::klu, linear::Choice::umfpack,
                                         linear::Choice::mumps, linear::Choice::banded));

TEST(IdaTime, FailuresBeforeACheckpointDoNotCountAgainAfterIt) {
  const SmallDae<Pendulum> system;
  ida::Ida integrator(system);
  Recorder seen;
  begin(integrator, system);
  EXPECT_TRUE(integrator.advance(0.7, seen));
  Kept kept(integrator);
  kept.statistics.newton_failures = ida::Options{}.max_failures_between_outputs + 1;
  integrator.resume(kept.snapshot(), kept.linear_solver);
  EXPECT_TRUE(integrator.advance(0.8, seen));
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
  begin(integrator, system);
  EXPECT_TRUE(integrator.advance(0.5, seen));
  EXPECT_THROW(integrator.advance(0.4, seen), std::invalid_argument);
  const std::vector<double> two(2);
  EXPECT_THROW(integrator.start(0.0, two, two), std::invalid_argument);
}

}  // namespace
}  // namespace talus::test
