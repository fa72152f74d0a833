#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "ida/ida.hpp"
#include "kinsol/kinsol.hpp"
#include "kinsol/newton.hpp"
#include "unit/ida_problems.hpp"
#include "unit/shear_layer.hpp"

namespace talus::test {
namespace {

struct Watcher final : core::Observer {
  std::vector<double> times;
  bool on_step(const core::Snapshot& snapshot) override {
    times.push_back(snapshot.t);
    for (const double rate : snapshot.yp) EXPECT_EQ(rate, 0.0);
    return true;
  }
};

/// The steady state of time t from the system's own initial state, and what it took.
struct Found {
  std::vector<double> y;
  core::Statistics statistics;
};
Found steady(const core::DaeSystem& system, const kinsol::Options& options = {}, double t = 0.0) {
  kinsol::Kinsol integrator(system, options);
  Watcher watcher;
  std::vector<double> y(system.layout().size()), yp(y.size());
  system.initial_state(t, y, yp);
  integrator.start(t, y, yp);
  EXPECT_TRUE(integrator.advance(t, watcher));
  EXPECT_EQ(watcher.times, std::vector<double>{t});
  const auto now = integrator.current();
  return {{now.y.begin(), now.y.end()}, now.statistics};
}

kinsol::Options without_continuation() {
  kinsol::Options options;
  options.continuation.allowed = false;
  return options;
}

TEST(Kinsol, ALinearSaddlePointTakesOneIteration) {
  Tied model;  // u1' = -k u1 + p, u2' = -k u2 + p, u1 + u2 = q: p is algebraic, of index 2
  const SmallDae<Tied> system(model);
  const auto found = steady(system, without_continuation(), 0.7);
  const double q = model.q(0.7);
  EXPECT_NEAR(found.y[0], 0.5 * q, 1e-14);
  EXPECT_NEAR(found.y[1], 0.5 * q, 1e-14);
  EXPECT_NEAR(found.y[2], 0.5 * model.k * q, 1e-14);
  EXPECT_EQ(found.statistics.newton_iterations, 1);
  EXPECT_EQ(found.statistics.jacobians, 1);
  EXPECT_EQ(found.statistics.factorisations, 1);
  EXPECT_EQ(found.statistics.steps, 1);
  EXPECT_EQ(found.statistics.restarts, 0);
}

TEST(Kinsol, OutputTimesGiveASequenceOfQuasiSteadyStates) {
  const SmallDae<Tied> system;
  kinsol::Kinsol integrator(system, without_continuation());
  Watcher watcher;
  integrator.start(0.0, system.model.y_0, system.model.yp_0);
  for (const double t : {0.2, 0.9, 1.5}) {
    EXPECT_TRUE(integrator.advance(t, watcher));
    EXPECT_EQ(integrator.current().t, t);
    EXPECT_NEAR(integrator.current().y[0], 0.5 * std::sin(t), 1e-14);
  }
  EXPECT_EQ(watcher.times, (std::vector<double>{0.2, 0.9, 1.5}));
  EXPECT_EQ(integrator.current().statistics.steps, 3);
  EXPECT_THROW(integrator.advance(1.4, watcher), std::invalid_argument);
}

/// Rates of 1e8 and of 1 side by side; root (8, 2).
struct Stiff {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, differential};
  std::array<double, n> tolerances = {1e-6, 1e-6}, y_0 = {}, yp_0 = {};
  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] + 1e8 * (y[0] - y[1] * y[1] * y[1]), yp[1] + y[0] + y[1] - 10.0};
  }
};

TEST(Kinsol, AStiffSystemHasItsKnownRoot) {
  const auto found = steady(SmallDae<Stiff>(), without_continuation());
  EXPECT_NEAR(found.y[0], 8.0, 1e-10);
  EXPECT_NEAR(found.y[1], 2.0, 1e-10);
}

/// Two rows that nearly say the same: a tiny residual is no root. Root (1, 1).
struct NearlyDependent {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, algebraic};
  std::array<double, n> tolerances = {1e-6, 1e-6}, y_0 = {}, yp_0 = {};
  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    using std::exp;
    const S sum = y[0] + y[1] - 2.0;
    return {yp[0] + sum, sum + 1e-7 * (exp(y[1]) - std::exp(1.0))};
  }
};

TEST(Kinsol, ASmallResidualIsNotTakenForARoot) {
  const auto found = steady(SmallDae<NearlyDependent>(), without_continuation());
  EXPECT_NEAR(found.y[0], 1.0, 1e-6);
  EXPECT_NEAR(found.y[1], 1.0, 1e-6);
}

/// y' = -f(y) in one unknown, from y_0.
struct Scalar {
  static constexpr int n = 1;
  std::function<core::Dual<1>(const core::Dual<1>&)> f;
  std::array<core::Kind, n> kinds = {differential};
  std::array<double, n> tolerances = {1e-6}, y_0 = {}, yp_0 = {};
  std::array<double, n> residual(double, const std::array<double, n>& y, const std::array<double, n>& yp) const {
    return {yp[0] + f(core::Dual<1>(y[0])).value};
  }
  std::array<core::Dual<1>, n> residual(double, const std::array<core::Dual<1>, n>& y,
                                        const std::array<core::Dual<1>, n>& yp) const {
    return {yp[0] + f(y[0])};
  }
};

TEST(Kinsol, TheLineSearchConvergesWhereFullStepsFlyApart) {
  Scalar model;  // plain Newton diverges beyond |y| = 1.39
  model.f = [](const core::Dual<1>& y) { return y.chain(std::atan(y.value), 1.0 / (1.0 + y.value * y.value)); };
  for (const double from : {2.0, -5.0, 15.0}) {
    model.y_0 = {from};
    const auto found = steady(SmallDae<Scalar>(model), without_continuation());
    EXPECT_NEAR(found.y[0], 0.0, 1e-9) << "from " << from;
    EXPECT_GT(found.statistics.residuals, found.statistics.newton_iterations + 2) << "no step was shortened";
  }
}

TEST(Kinsol, AStepOfTheContinuationIsImplicitEuler) {
  Scalar model;
  model.f = [](const core::Dual<1>& y) { return y * y; };
  const SmallDae<Scalar> system(model);
  const kinsol::Options options;
  core::Statistics statistics;
  bridge::Equations equations(system, options.linear, statistics);
  kinsol::Newton newton(equations, options, statistics);
  const std::vector<double> from = {2.0};
  std::vector<double> y = from;
  EXPECT_TRUE(newton.solve({.t = 0.0, .c_j = 1.0 / 0.25, .from = from}, y, 10));
  EXPECT_NEAR(y[0], -2.0 + 2.0 * std::sqrt(3.0), 1e-10);  // y + y^2/4 = 2
}

TEST(Kinsol, TheContinuationPassesAResidualsLocalMinimum) {
  Scalar model;  // |f| has a minimum of 0.91 at sqrt(2/3), into which the line search falls from 0
  model.f = [](const core::Dual<1>& y) { return y * y * y - 2.0 * y + 2.0; };
  const auto found = steady(SmallDae<Scalar>(model));
  EXPECT_NEAR(found.y[0], -1.769292354238631, 1e-9);
  EXPECT_GT(found.statistics.restarts, 0);
  EXPECT_GT(found.statistics.newton_failures, 0);
}

/// As above, through an algebraic z = y^3 of which a rate makes no sense.
struct Slaved {
  static constexpr int n = 2;
  std::array<core::Kind, n> kinds = {differential, algebraic};
  std::array<double, n> tolerances = {1e-6, 1e-6}, y_0 = {}, yp_0 = {};
  static double at_rest(double z, double rate) { return rate == 0.0 ? z : std::nan(""); }
  static core::Dual<n> at_rest(const core::Dual<n>& z, const core::Dual<n>&) { return z; }
  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] + at_rest(y[1], yp[1]) - 2.0 * y[0] + 2.0, y[1] - y[0] * y[0] * y[0]};
  }
};

TEST(Kinsol, InTheContinuationAlgebraicUnknownsHaveNoRate) {
  const auto found = steady(SmallDae<Slaved>());
  EXPECT_NEAR(found.y[0], -1.769292354238631, 1e-9);
  EXPECT_GT(found.statistics.restarts, 0);
  EXPECT_EQ(found.statistics.inadmissible_states, 0);
}

/// In each layer between a cell's lower face and the surface: drive = friction + stress on the face.
double worst_imbalance(const ShearLayer& layer, std::span<const double> u) {
  const auto& p = layer.parameters();
  const double dz = layer.dz();
  double force = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double middle = (static_cast<double>(i) + 0.5) * dz, face = static_cast<double>(i + 1) * dz;
    force += (p.drive - p.wall * middle * std::tanh(u[i] / p.u_c)) * dz;
    const double slope = i + 1 < u.size() ? (u[i] - u[i + 1]) / dz : 2.0 * u[i] / dz;
    worst = std::max(worst, std::abs(force - layer.stress(face, slope)));
  }
  return worst / p.drive;
}

TEST(Kinsol, AYieldingLayerIsInBalanceWhateverTheScaleOfFriction) {
  for (const int n : {50, 100, 200}) {
    for (const double u_c : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
      const ShearLayer layer(n, {.u_c = u_c});
      const auto found = steady(layer, without_continuation());
      EXPECT_LT(worst_imbalance(layer, found.y), 1e-6) << n << " cells, u_c = " << u_c;
      EXPECT_GT(found.y[0], 1.0);
      EXPECT_LT(found.y[n - 1], 2.0 * u_c);
      EXPECT_LE(found.statistics.newton_iterations, 30) << n << " cells, u_c = " << u_c;
    }
  }
}

TEST(Kinsol, RestIsNotTakenForASteadyStateBecauseItIsStiff) {
  // At rest Newton's correction is of the size of s_0, far below any tolerance, and leaves half of the force.
  for (const double s_0 : {1e-10, 1e-12, 1e-14}) {
    const ShearLayer layer(100, {.s_0 = s_0});
    const auto found = steady(layer);
    EXPECT_LT(worst_imbalance(layer, found.y), 1e-6) << "s_0 = " << s_0;
    EXPECT_GT(found.y[0], 1.0) << "s_0 = " << s_0;
  }
}

TEST(Kinsol, TheContinuationFindsAPlasticLayer) {
  const ShearLayer layer(200, {.viscosity = 1e-4, .s_0 = 1e-8, .u_c = 1e-4});
  kinsol::Options options;
  options.max_iterations = 50;  // of the 150 that the line search alone would take
  const auto found = steady(layer, options);
  EXPECT_GT(found.statistics.restarts, 0);
  EXPECT_LT(worst_imbalance(layer, found.y), 1e-6);
}

TEST(Kinsol, TimeSteppingEndsInTheSameState) {
  const ShearLayer layer(50, {});
  const auto found = steady(layer);
  ida::Options options;
  options.rtol = 1e-8;
  ida::Ida stepping(layer, options);
  core::Observer observer;
  const std::vector<double> rest(50, 0.0);
  stepping.start(0.0, rest, rest);
  stepping.advance(1000.0, observer);
  for (int i = 0; i < 50; ++i) EXPECT_NEAR(found.y[i], stepping.current().y[i], 1e-6) << "cell " << i;
  EXPECT_LT(20 * found.statistics.residuals, stepping.current().statistics.residuals);
}

/// u' = q - u^3, and what was poured in and went out.
struct Tank {
  static constexpr int n = 3;
  static bool couples(int row, int column) { return row == column || (row == 2 && column == 0); }
  std::array<core::Kind, n> kinds = {differential, differential, differential};
  std::array<double, n> tolerances = {1e-6, 1e-6, 1e-6}, y_0 = {0.0, 7.0, 5.0}, yp_0 = {};
  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    const S out = y[0] * y[0] * y[0];
    return {yp[0] + out - 8.0, yp[1] - 8.0, yp[2] - out};
  }
};

TEST(Kinsol, AccumulatorsAreHeld) {
  const SmallDae<Tank> system;
  kinsol::Kinsol integrator(system);
  core::Observer observer;
  integrator.start(0.0, system.model.y_0, system.model.yp_0);
  integrator.advance(0.0, observer);
  EXPECT_NEAR(integrator.current().y[0], 2.0, 1e-10);
  EXPECT_EQ(integrator.current().y[1], 7.0);
  EXPECT_EQ(integrator.current().y[2], 5.0);
  EXPECT_NE(integrator.describe().find("2 accumulators held"), std::string::npos);
}

/// y' = 1 - y^3: its only column stands alone, and at the guess it is zero.
struct Flat {
  static constexpr int n = 1;
  std::array<core::Kind, n> kinds = {differential};
  std::array<double, n> tolerances = {1e-6}, y_0 = {}, yp_0 = {};
  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] + y[0] * y[0] * y[0] - 1.0};
  }
};

TEST(Kinsol, ASlopeThatVanishesAtTheGuessMakesNoAccumulator) { EXPECT_NEAR(steady(SmallDae<Flat>()).y[0], 1.0, 1e-10); }

TEST(Kinsol, DescribesItself) {
  const SmallDae<Tied> system;
  EXPECT_NE(kinsol::Kinsol(system).describe().find("SUNDIALS KINSOL "), std::string::npos);
  EXPECT_NE(kinsol::Kinsol(system).describe().find("pseudo-transient continuation"), std::string::npos);
  EXPECT_EQ(kinsol::Kinsol(system, without_continuation()).describe().find("continuation"), std::string::npos);
}

}  // namespace
}  // namespace talus::test
