#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "ida/damped_newton.hpp"

namespace talus::test {
namespace {

using ida::DampedNewton;
using bridge::Outcome;
using Status = DampedNewton::Status;

/// Uncoupled equations g(x_i) = 0 with their own slope, and counters.
struct Scalars final : ida::NewtonProblem {
  std::function<double(double)> g, slope;
  std::function<bool(double)> admissible = [](double) { return true; };
  std::vector<double> factors;
  double expected_drift = HUGE_VAL;
  double bound = HUGE_VAL;  // of what may be left in one unknown
  int n_residuals = 0, n_refreshes = 0;

  Scalars(std::function<double(double)> function, std::function<double(double)> derivative)
      : g(std::move(function)), slope(std::move(derivative)) {}
  Outcome residual(std::span<const double> x, std::span<double> r) override {
    ++n_residuals;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!admissible(x[i])) return Outcome::refused;
      r[i] = g(x[i]);
    }
    return Outcome::ok;
  }
  Outcome refresh(std::span<const double> x) override {
    ++n_refreshes;
    expected_drift = 0.0;
    factors.clear();
    for (const double v : x) factors.push_back(slope(v));
    return Outcome::ok;
  }
  Outcome solve(std::span<double> b) override {
    for (std::size_t i = 0; i < b.size(); ++i) b[i] /= factors[i];
    return Outcome::ok;
  }
  [[nodiscard]] double product(std::span<const double> a, std::span<const double> b) const override {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum / static_cast<double>(a.size());
  }
  [[nodiscard]] double largest(std::span<const double> v) const override {
    double most = 0.0;
    for (const double x : v) most = std::max(most, std::abs(x) / bound);
    return most;
  }
  [[nodiscard]] double share_left(std::span<const double> r, std::span<const double> r_start) const override {
    return std::sqrt(product(r, r) / product(r_start, r_start));
  }
  [[nodiscard]] double drift() const override { return expected_drift; }
};

Scalars arctan() {
  return {[](double x) { return std::atan(x); }, [](double x) { return 1.0 / (1.0 + x * x); }};
}

TEST(DampedNewton, ConvergesWhereTheUndampedIterationFliesApart) {
  auto problem = arctan();  // plain Newton diverges beyond |x| = 1.39
  for (const double from : {1.3, 2.0, 5.0, 15.0}) {
    problem.expected_drift = HUGE_VAL;
    DampedNewton newton({});
    std::vector<double> x = {from};
    EXPECT_EQ(newton.solve(problem, x, 1e-10), Status::converged) << from;
    EXPECT_NEAR(x[0], 0.0, 1e-9);
  }
  ida::NewtonOptions undamped;
  undamped.max_halvings = 0;
  DampedNewton newton(undamped);
  problem.expected_drift = HUGE_VAL;
  std::vector<double> x = {15.0};
  EXPECT_EQ(newton.solve(problem, x, 1e-10), Status::diverged);
}

TEST(DampedNewton, KeepsTheFactorsWhileTheyContract) {
  Scalars problem([](double x) { return x * x - 2.0; }, [](double x) { return 2.0 * x; });
  DampedNewton newton({});
  for (const double from : {1.40, 1.43, 1.35}) {
    std::vector<double> x = {from};
    EXPECT_EQ(newton.solve(problem, x, 1e-9), Status::converged);
    EXPECT_NEAR(x[0], std::sqrt(2.0), 1e-8);
  }
  EXPECT_EQ(problem.n_refreshes, 1);
}

TEST(DampedNewton, RenewsFactorsThatDoNotContract) {
  Scalars problem([](double x) { return x * x - 2.0; }, [](double x) { return 2.0 * x; });
  problem.factors = {0.5};  // far from the slope of 2.8: x - g/0.5 flies apart
  problem.expected_drift = 0.0;
  DampedNewton newton({});
  std::vector<double> x = {1.5};
  EXPECT_EQ(newton.solve(problem, x, 1e-9), Status::converged);
  EXPECT_NEAR(x[0], std::sqrt(2.0), 1e-8);
  EXPECT_GE(problem.n_refreshes, 1);
}

TEST(DampedNewton, TheSecantMakesUpForAWrongSlope) {
  // With the slope wrong by a constant factor the plain iteration contracts by 1/2; one secant step finds the factor.
  Scalars problem([](double x) { return x - 1.0; }, [](double) { return 2.0; });
  problem.factors = {2.0, 2.0};
  problem.expected_drift = 0.0;
  DampedNewton newton({});
  std::vector<double> x = {5.0, -3.0};
  EXPECT_EQ(newton.solve(problem, x, 1e-12), Status::converged);
  EXPECT_NEAR(x[0], 1.0, 1e-12);
  EXPECT_NEAR(x[1], 1.0, 1e-12);
  EXPECT_LE(newton.iterations(), 3);
  EXPECT_EQ(problem.n_refreshes, 0);
}

TEST(DampedNewton, SecantsOfASolveServeTheNextWhileTheFactorsStay) {
  // Two slopes, wrong by factors of 2 and 1.25: two secants find both, and the next solve knows them from its first step.
  Scalars problem([](double x) { return x - 1.0; }, [](double) { return 1.0; });
  problem.factors = {2.0, 1.25};
  problem.expected_drift = 0.0;
  const auto iterations = [&](DampedNewton& newton) {
    std::vector<double> x = {5.0, -3.0};
    EXPECT_EQ(newton.solve(problem, x, 1e-12), Status::converged);
    EXPECT_NEAR(x[0], 1.0, 1e-12);
    EXPECT_NEAR(x[1], 1.0, 1e-12);
    return newton.iterations();
  };
  ida::NewtonOptions options;
  options.doubt = 0;
  DampedNewton newton(options);
  const int first = iterations(newton);
  EXPECT_LE(first, 4);
  EXPECT_LT(iterations(newton), first);
  newton.forget();
  EXPECT_EQ(iterations(newton), first);
  options.depth = 0;
  DampedNewton plain(options);
  EXPECT_GT(iterations(plain), 20);
  EXPECT_EQ(problem.n_refreshes, 0);
}

/// Stiff within 0.01 of the root at 0.0055, soft outside; factors of the stiff state at hand, the start in the soft one.
Scalars yielding() {
  Scalars problem([](double x) { return std::tanh(100.0 * x) + 0.05 * x - 0.5; },
                  [](double x) { return 100.0 / std::pow(std::cosh(100.0 * x), 2) + 0.05; });
  problem.factors = {100.0};
  problem.expected_drift = 0.0;
  return problem;
}

TEST(DampedNewton, InDoubtTakesNoSmallCorrectionOfStiffFactorsForAnAnswer) {
  constexpr double tolerance = 0.2;
  auto problem = yielding();
  DampedNewton newton({});
  std::vector<double> x = {1.0};
  EXPECT_EQ(newton.solve(problem, x, tolerance), Status::converged);
  EXPECT_NEAR(x[0], 0.0055, 1e-3);

  ida::NewtonOptions trusting;
  trusting.doubt = 0;
  auto same = yielding();
  x = {1.0};
  EXPECT_EQ(DampedNewton(trusting).solve(same, x, tolerance), Status::converged);
  EXPECT_NEAR(x[0], 1.0, 0.01);
}

TEST(DampedNewton, DoubtEndsAfterSolvesWithoutTroubleAndComesBackWithIt) {
  ida::NewtonOptions options;
  options.doubt = 3;
  DampedNewton newton(options);
  const auto settles = [&] {  // false: the far-off start is taken for the answer
    auto problem = yielding();
    std::vector<double> x = {1.0};
    EXPECT_EQ(newton.solve(problem, x, 0.2), Status::converged);
    return x[0] < 0.5;
  };
  Scalars easy([](double x) { return x - 1.0; }, [](double) { return 1.0; });
  const auto calm_solves = [&](int n) {
    for (int i = 0; i < n; ++i) {
      std::vector<double> x = {3.0};
      EXPECT_EQ(newton.solve(easy, x, 1e-9), Status::converged);
    }
  };
  calm_solves(3);
  EXPECT_FALSE(settles());
  auto hard = arctan();
  std::vector<double> x = {15.0};  // shortens its steps
  EXPECT_EQ(newton.solve(hard, x, 1e-9), Status::converged);
  calm_solves(1);
  EXPECT_TRUE(settles());
}

TEST(DampedNewton, AMeanOverManyUnknownsDoesNotHideOne) {
  const auto error_of_one = [](double bound) {
    Scalars problem([](double x) { return x * x - 2.0; }, [](double x) { return 2.0 * x; });
    problem.bound = bound;
    std::vector<double> x(10000, std::sqrt(2.0));
    x[77] = 1.6;
    DampedNewton newton({});
    EXPECT_EQ(newton.solve(problem, x, 1e-3), Status::converged);
    return std::abs(x[77] - std::sqrt(2.0));
  };
  EXPECT_GT(error_of_one(HUGE_VAL), 1e-4);
  EXPECT_LT(error_of_one(1e-9), 1e-9);
}

TEST(DampedNewton, ShortensAStepThatIsRefused) {
  Scalars problem([](double x) { return std::log(x); }, [](double x) { return 1.0 / x; });
  problem.admissible = [](double x) { return x > 0.0; };
  DampedNewton newton({});
  std::vector<double> x = {6.0};  // the full step leads to 6 - 6 log 6 < 0
  EXPECT_EQ(newton.solve(problem, x, 1e-9), Status::converged);
  EXPECT_NEAR(x[0], 1.0, 1e-8);
  x = {-1.0};
  EXPECT_EQ(newton.solve(problem, x, 1e-9), Status::refused);
}

TEST(DampedNewton, GivesUpWhereThereIsNoRoot) {
  Scalars problem([](double x) { return x * x + 1.0; }, [](double x) { return 2.0 * x; });
  DampedNewton newton({});
  std::vector<double> x = {1.0};
  EXPECT_EQ(newton.solve(problem, x, 1e-9), Status::diverged);
  EXPECT_LE(newton.iterations(), 41 + 5);
  Scalars flat([](double) { return 1.0; }, [](double) { return 0.0; });
  EXPECT_EQ(newton.solve(flat, x, 1e-9), Status::diverged);
}

}  // namespace
}  // namespace talus::test
