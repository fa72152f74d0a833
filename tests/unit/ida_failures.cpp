#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "ida/ida.hpp"
#include "unit/ida_problems.hpp"

namespace talus::test {
namespace {

struct Silent final : core::Observer {};

/// y' = rate(t, y) in the first unknown; the second is algebraic, z = y.
struct Driven {
  static constexpr int n = 2;
  std::function<double(double, double)> rate;
  std::array<core::Kind, n> kinds = {differential, algebraic};
  std::array<double, n> tolerances = {1e-8, 1e-8};
  std::array<double, n> y_0 = {1.0, 1.0}, yp_0 = {};

  template <class S>
  std::array<S, n> residual(double t, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] - rate_of(t, y[0]), y[1] - y[0]};
  }
  [[nodiscard]] double rate_of(double t, double y) const { return rate(t, y); }
  [[nodiscard]] core::Dual<n> rate_of(double t, const core::Dual<n>& y) const {
    constexpr double h = 1e-6;
    return y.chain(rate(t, y.value), (rate(t, y.value + h) - rate(t, y.value - h)) / (2.0 * h));
  }
};

/// Runs `rate` to t = 2 and returns what() of the IntegrationError, or "".
std::string failure_of(Driven model, const ida::Options& options = {}) {
  const SmallDae<Driven> system(std::move(model));
  ida::Ida integrator(system, options);
  Silent observer;
  try {
    integrator.start(0.0, system.model.y_0, system.model.yp_0);
    integrator.advance(2.0, observer);
  } catch (const core::IntegrationError& error) {
    EXPECT_EQ(error.code(), core::ExitCode::solver);
    return error.what();
  }
  return "";
}

testing::AssertionResult says(const std::string& text, std::initializer_list<const char*> words) {
  for (const char* word : words)
    if (text.find(word) == std::string::npos) return testing::AssertionFailure() << "no '" << word << "' in: " << text;
  return testing::AssertionSuccess();
}

TEST(IdaFailures, AnExceptionOfTheModelComesOutAsItWas) {
  struct Planted : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  for (const auto kind : {ida::Newton::damped, ida::Newton::stock}) {
    ida::Options options;
    options.newton.kind = kind;
    Driven model;
    model.rate = [](double t, double) { return t > 1.0 ? throw Planted("planted") : 1.0; };
    EXPECT_THROW(failure_of(model, options), Planted);
    model.rate = [](double, double) -> double { throw Planted("at once"); };
    EXPECT_THROW(failure_of(model, options), Planted);
  }
}

TEST(IdaFailures, AnInadmissibleTrialIsCountedAndTheRunGoesOn) {
  Driven model;  // y falls towards 0.5; large steps overshoot into y < 0.45
  model.rate = [](double, double y) {
    if (y < 0.45) throw core::InadmissibleState("y below 0.45");
    return -40.0 * (y - 0.5);
  };
  const SmallDae<Driven> system(model);
  ida::Options options;
  options.initial_step = 0.05;
  ida::Ida integrator(system, options);
  Silent observer;
  integrator.start(0.0, model.y_0, model.yp_0);
  EXPECT_TRUE(integrator.advance(2.0, observer));
  EXPECT_NEAR(integrator.current().y[0], 0.5, 1e-4);
  EXPECT_GT(integrator.current().statistics.inadmissible_states, 0);
}

TEST(IdaFailures, ADomainThatEndsIsReportedWithTheModelsWords) {
  Driven model;
  model.rate = [](double t, double) {
    return t > 1.0 ? throw core::InadmissibleState("H of column 7 is not positive") : 1.0;
  };
  for (const auto kind : {ida::Newton::damped, ida::Newton::stock}) {
    ida::Options options;
    options.newton.kind = kind;
    EXPECT_TRUE(says(failure_of(model, options),
                     {"IDA_REP_RES_ERR", "H of column 7 is not positive", "t = ", "order ", "step "}));
  }
}

TEST(IdaFailures, ANaNIsNamedWithItsRow) {
  Driven model;
  model.rate = [](double t, double) { return t > 1.0 ? std::numeric_limits<double>::quiet_NaN() : 1.0; };
  EXPECT_TRUE(says(failure_of(model), {"not finite", "row 0 of the test"}));
  model.rate = [](double, double) { return std::numeric_limits<double>::infinity(); };
  EXPECT_TRUE(says(failure_of(model), {"no consistent state", "not finite", "row 0 of the test"}));
}

TEST(IdaFailures, ABlowUpEndsWithTheWorstRowsByName) {
  Driven model;  // y = 1/(1 - t)
  model.rate = [](double, double y) { return y * y; };
  const auto text = failure_of(model);
  EXPECT_TRUE(says(text, {"worst rows by", "row 0 of the test", ", value ", "IDA_", "after "}));
}

TEST(IdaFailures, ACrawlIsEndedByTheGuards) {
  Driven model;
  model.rate = [](double t, double) { return std::sin(1e6 * t); };
  ida::Options options;
  options.rtol = 1e-10;
  options.max_steps_between_outputs = 500;
  model.tolerances = {1e-12, 1e-12};
  EXPECT_TRUE(says(failure_of(model, options), {"too many steps between two outputs"}));
}

TEST(IdaFailures, AStartWithoutAConsistentStateNamesTheWorstRows) {
  Driven model;  // so steep that no implicit Euler step of any size has a solution
  model.rate = [](double, double y) { return 1e12 * (1.0 + y * y); };
  EXPECT_TRUE(says(failure_of(model), {"no consistent state", "worst rows by", "row 0 of the test"}));
}

/// The second row is the first one twice over: singular for any c_j.
struct Twins {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, differential};
  std::array<double, n> tolerances = {1e-8, 1e-8}, y_0 = {1.0, 1.0}, yp_0 = {};
  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    const S r = yp[0] + y[0] + yp[1];
    return {r, 2.0 * r - 1.0};
  }
};

TEST(IdaFailures, ASingularJacobianIsSaid) {
  const SmallDae<Twins> system;
  for (const auto choice : {linear::Choice::klu, linear::Choice::umfpack, linear::Choice::banded}) {
    ida::Options options;
    options.linear.choice = choice;
    ida::Ida integrator(system, options);
    try {
      integrator.start(0.0, system.model.y_0, system.model.yp_0);
      FAIL() << "a singular system was started";
    } catch (const core::IntegrationError& error) {
      EXPECT_TRUE(says(error.what(), {"no consistent state", "Jacobian", "t = 0"}));
    }
  }
}

TEST(IdaFailures, OptionsOutsideTheirRangeAreRefused) {
  const SmallDae<Twins> system;
  const auto refused = [&](auto change) {
    ida::Options options;
    change(options);
    EXPECT_THROW(ida::Ida(system, options), std::invalid_argument);
  };
  refused([](ida::Options& o) { o.rtol = 0.0; });
  refused([](ida::Options& o) { o.max_order = 6; });
  refused([](ida::Options& o) { o.max_step = -1.0; });
  refused([](ida::Options& o) { o.start_step = 0.0; });
  refused([](ida::Options& o) { o.newton.tolerance = 0.0; });
  refused([](ida::Options& o) { o.max_failures_in_a_row = 0; });
  refused([](ida::Options& o) { o.linear.ordering = {0, 0}; });
}

TEST(IdaFailures, AfterAFailureTheLastGoodStateIsShown) {
  Driven model;
  model.rate = [](double t, double) { return t > 1.0 ? throw core::InadmissibleState("end") : 1.0; };
  const SmallDae<Driven> system(model);
  ida::Ida integrator(system);
  Silent observer;
  integrator.start(0.0, model.y_0, model.yp_0);
  EXPECT_THROW(integrator.advance(2.0, observer), core::IntegrationError);
  const auto now = integrator.current();
  EXPECT_GT(now.t, 0.9);
  EXPECT_LE(now.t, 1.0);
  EXPECT_NEAR(now.y[0], 1.0 + now.t, 1e-4);
  EXPECT_GT(now.statistics.newton_failures, 0);
}

}  // namespace
}  // namespace talus::test
