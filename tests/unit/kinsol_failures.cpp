#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/errors.hpp"
#include "kinsol/kinsol.hpp"
#include "unit/ida_problems.hpp"

namespace talus::test {
namespace {

/// y' = -f(y) in the first unknown, with slope df/dy; the second is algebraic, z = y.
struct Sought {
  static constexpr int n = 2;
  std::function<double(double)> f, slope;
  std::array<core::Kind, n> kinds = {differential, algebraic};
  std::array<double, n> tolerances = {1e-8, 1e-8};
  std::array<double, n> y_0 = {1.0, 1.0}, yp_0 = {};

  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] + f_of(y[0]), y[1] - y[0]};
  }
  [[nodiscard]] double f_of(double y) const { return f(y); }
  [[nodiscard]] core::Dual<n> f_of(const core::Dual<n>& y) const { return y.chain(f(y.value), slope(y.value)); }
};

/// Seeks the steady state and returns what() of the IntegrationError, or "". `integrator` must be at its guess.
std::string failure_of(kinsol::Kinsol& integrator) {
  core::Observer observer;
  try {
    integrator.advance(0.0, observer);
  } catch (const core::IntegrationError& error) {
    EXPECT_EQ(error.code(), core::ExitCode::solver);
    return error.what();
  }
  return "";
}
template <class Model>
std::string failure_of(Model model, const kinsol::Options& options = {}) {
  const SmallDae<Model> system(std::move(model));
  kinsol::Kinsol integrator(system, options);
  integrator.start(0.0, system.model.y_0, system.model.yp_0);
  return failure_of(integrator);
}

testing::AssertionResult says(const std::string& text, std::initializer_list<const char*> words) {
  for (const char* word : words)
    if (text.find(word) == std::string::npos) return testing::AssertionFailure() << "no '" << word << "' in: " << text;
  return testing::AssertionSuccess();
}

TEST(KinsolFailures, AnInadmissibleTrialShortensTheStep) {
  Sought model;  // Newton's first step from 5 leads to 5 - 5 log 5 = -3
  model.f = [](double y) { return y > 0.0 ? std::log(y) : throw core::InadmissibleState("y is not positive"); };
  model.slope = [](double y) { return 1.0 / y; };
  model.y_0 = {5.0, 5.0};
  const SmallDae<Sought> system(model);
  kinsol::Options options;
  options.continuation.allowed = false;
  kinsol::Kinsol integrator(system, options);
  integrator.start(0.0, model.y_0, model.yp_0);
  EXPECT_EQ(failure_of(integrator), "");
  EXPECT_NEAR(integrator.current().y[0], 1.0, 1e-10);
  EXPECT_EQ(integrator.current().statistics.inadmissible_states, 1);
}

TEST(KinsolFailures, AGuessOutsideTheDomainIsReportedWithTheModelsWords) {
  Sought model;
  model.f = [](double) -> double { throw core::InadmissibleState("H of column 7 is not positive"); };
  model.slope = [](double) { return 1.0; };
  EXPECT_TRUE(says(failure_of(model), {"no steady state", "H of column 7 is not positive", "t = 0 s"}));
}

TEST(KinsolFailures, AnExceptionOfTheModelComesOutAsItWas) {
  struct Planted : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  Sought model;
  model.slope = [](double) { return 1.0; };
  model.f = [](double y) { return y != 1.0 ? throw Planted("at the first trial") : 1.0; };
  EXPECT_THROW(failure_of(model), Planted);
  model.f = [](double) { return 1.0; };
  model.slope = [](double) -> double { throw Planted("in the Jacobian"); };
  EXPECT_THROW(failure_of(model), Planted);
}

TEST(KinsolFailures, ANaNIsNamedWithItsRow) {
  Sought model;
  model.f = [](double) { return std::numeric_limits<double>::quiet_NaN(); };
  model.slope = [](double) { return 1.0; };
  EXPECT_TRUE(says(failure_of(model), {"no steady state", "not finite", "row 0 of the test"}));
}

TEST(KinsolFailures, WithoutAnyRootTheWorstRowsAreNamed) {
  Sought model;
  model.f = [](double y) { return y * y + 1.0; };
  model.slope = [](double y) { return 2.0 * y; };
  model.y_0 = {3.0, 3.0};
  EXPECT_TRUE(says(failure_of(model), {"KIN_", "; then the continuation", " continuation steps", "worst rows by",
                                       "row 0 of the test", ", value "}));
  kinsol::Options options;
  options.continuation.allowed = false;
  const auto text = failure_of(model, options);
  EXPECT_TRUE(says(text, {"(KIN_", "after ", " iterations and 0 continuation steps", "row 0"}));
  EXPECT_EQ(text.find("; then"), std::string::npos);
}

/// The second row is the first one twice over.
struct Dependent {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, differential};
  std::array<double, n> tolerances = {1e-8, 1e-8}, y_0 = {1.0, 1.0}, yp_0 = {};
  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>&) const {
    const S r = y[0] + 3.0 * y[1] - 1.0;
    return {r, 2.0 * r};
  }
};

TEST(KinsolFailures, ASingularJacobianNamesItsPlaceAndTheWorstRows) {
  for (const auto choice : {linear::Choice::klu, linear::Choice::umfpack, linear::Choice::banded}) {
    kinsol::Options options;
    options.linear.choice = choice;
    EXPECT_TRUE(says(failure_of(Dependent{}, options), {"no steady state", "Jacobian", "row 0 of the test",
                                                        "row 1 of the test", "worst rows by scaled residual"}));
  }
}

TEST(KinsolFailures, AFailureLeavesTheLastStateAsItWas) {
  Sought model;
  model.f = [](double y) { return y * y + 1.0; };
  model.slope = [](double y) { return 2.0 * y; };
  const SmallDae<Sought> system(model);
  kinsol::Kinsol integrator(system);
  integrator.start(0.0, model.y_0, model.yp_0);
  EXPECT_NE(failure_of(integrator), "");
  EXPECT_EQ(integrator.current().y[0], 1.0);
  EXPECT_EQ(integrator.current().statistics.steps, 0);
}

TEST(KinsolFailures, MistakesOfTheCallerAreRefused) {
  const SmallDae<Dependent> system;
  core::Observer observer;
  kinsol::Kinsol integrator(system);
  EXPECT_THROW(integrator.advance(0.0, observer), std::logic_error);
  const std::array<double, 1> one = {};
  EXPECT_THROW(integrator.start(0.0, one, one), std::invalid_argument);
  const auto refused = [&](auto&& spoil) {
    kinsol::Options options;
    spoil(options);
    EXPECT_THROW(kinsol::Kinsol(system, options), std::invalid_argument);
  };
  refused([](auto& o) { o.rtol = 0.0; });
  refused([](auto& o) { o.tolerance = -1.0; });
  refused([](auto& o) { o.max_iterations = 0; });
  refused([](auto& o) { o.continuation.growth = 1.0; });
  refused([](auto& o) { o.continuation.first_step = 0.0; });
  Dependent without_tolerance;
  without_tolerance.tolerances = {1e-8, 0.0};
  const SmallDae<Dependent> other(without_tolerance);
  EXPECT_THROW(kinsol::Kinsol{other}, std::invalid_argument);
}

}  // namespace
}  // namespace talus::test
