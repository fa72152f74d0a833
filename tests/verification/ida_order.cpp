#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "support/held_step.hpp"
#include "support/table.hpp"
#include "unit/ida_problems.hpp"

/// Order in time on systems with known solutions: differential unknowns ("u") and the multiplier of an index-2 constraint ("p")
/// apart, at each order of the backward differentiation formula with the step held, and against the tolerance.
namespace {

using namespace talus;
using test::Pendulum;
using test::SmallDae;

/// The pendulum, pushed from rest by a horizontal force F whose first five derivatives are zero at the start: the first steps, at
/// orders below the one under test, then leave no trace. Multiplier u^2 + v^2 - g y + F x; `closed` gives it in that form
/// (index 1), else by the constraint (index 2).
template <bool closed>
struct PushedPendulum : Pendulum {
  PushedPendulum() { y_0 = {0.0, -1.0, 0.0, 0.0, g}; }
  static double force(double t) { return 8.0 * std::pow(std::sin(t), 6); }

  template <class S>
  std::array<S, n> residual(double t, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    auto r = Pendulum::residual(t, y, yp);
    r[2] -= force(t);
    if (closed) r[4] = y[4] * (y[0] * y[0] + y[1] * y[1]) - (y[2] * y[2] + y[3] * y[3] - g * y[1] + force(t) * y[0]);
    return r;
  }
};

/// Its angle and angular velocity, by the classical Runge-Kutta method with 1e-4 s steps.
class PushedAngle {
 public:
  static constexpr double end = 2.0;

  PushedAngle() {
    const auto rate = [](double t, double angle) {
      return -Pendulum::g * std::sin(angle) + PushedPendulum<false>::force(t) * std::cos(angle);
    };
    double angle = 0.0, omega = 0.0;
    for (int i = 0; i * h_ <= end; ++i) {
      states_.push_back({angle, omega});
      const double t = i * h_;
      const double k1 = omega, l1 = rate(t, angle);
      const double k2 = omega + 0.5 * h_ * l1, l2 = rate(t + 0.5 * h_, angle + 0.5 * h_ * k1);
      const double k3 = omega + 0.5 * h_ * l2, l3 = rate(t + 0.5 * h_, angle + 0.5 * h_ * k2);
      const double k4 = omega + h_ * l3, l4 = rate(t + h_, angle + h_ * k3);
      angle += h_ / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      omega += h_ / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
  }
  /// At a multiple of 1e-4 s.
  [[nodiscard]] std::pair<double, double> at(double t) const { return states_.at(std::lround(t / h_)); }

 private:
  static constexpr double h_ = 1e-4;
  std::vector<std::pair<double, double>> states_;
};

struct Error {
  double u = 0.0, p = 0.0;
  void grow(double in_u, double in_p) {
    u = std::max(u, in_u);
    p = std::max(p, in_p);
  }
};

/// Position and velocity together; multiplier.
Error error_of(const PushedAngle& exact, const core::Snapshot& now) {
  const auto [angle, omega] = exact.at(now.t);
  const double s = std::sin(angle), c = std::cos(angle);
  const auto& y = now.y;
  const double off = std::max(std::hypot(y[0] - s, y[1] + c), std::hypot(y[2] - omega * c, y[3] - omega * s));
  return {off, std::abs(y[4] - (omega * omega + Pendulum::g * c + PushedPendulum<false>::force(now.t) * s))};
}

template <class Model>
Error largest_error(const PushedAngle& exact, int order, double step) {
  Model model;
  model.tolerances = {1.0, 1.0, 1.0, 1.0, 10.0};
  const SmallDae<Model> system(model);
  // What Newton's method leaves in u, times c_j, is an error of p: 3e-10 at the finest step with a tolerance of 1e-13.
  ida::Ida integrator(system, tests::held_step(order, step, 1e-1, 1e-14));
  std::vector<double> y(Model::n), yp(Model::n);
  system.initial_state(0.0, y, yp);
  integrator.start(0.0, y, yp);
  Error largest;
  tests::HeldStepObserver observer(order, step, [&](const core::Snapshot& now) {
    const auto error = error_of(exact, now);
    largest.grow(error.u, error.p);
  });
  integrator.advance(PushedAngle::end, observer);
  EXPECT_EQ(observer.n_lost, 0) << "order " << order << ", step " << step;
  EXPECT_GT(observer.n_held, PushedAngle::end / step - 8) << "order " << order << ", step " << step;
  return largest;
}

struct Orders {
  std::vector<Error> finest;  ///< a formula, from order 1 up
};

template <class Model>
Orders expect_orders(const std::string& name, const PushedAngle& exact) {
  tests::Table table(name, {"order", "step [s]", "error of u", "error of p", "order of u", "order of p"});
  Orders all;
  for (int order = 1; order <= 5; ++order) {
    std::vector<double> steps, u, p;
    for (const double step : {0.02, 0.01, 0.005, 0.0025}) {
      steps.push_back(step);
      const auto error = largest_error<Model>(exact, order, step);
      u.push_back(error.u);
      p.push_back(error.p);
      const bool first = steps.size() == 1;
      const auto latest = [&](const std::vector<double>& e) {
        return first ? tests::Table::Cell("") : diagnostics::observed_orders(steps, e).back();
      };
      table.row({double(order), steps.back(), u.back(), p.back(), latest(u), latest(p)});
    }
    EXPECT_NEAR(diagnostics::observed_orders(steps, u).back(), order, 0.25) << "u, order " << order;
    EXPECT_NEAR(diagnostics::observed_orders(steps, p).back(), order, 0.25) << "p, order " << order;
    all.finest.push_back({u.back(), p.back()});
  }
  return all;
}

TEST(IdaOrder, EachFormulaHasItsOrderAndIndexTwoDoesNotDegradeIt) {
  const PushedAngle exact;
  const auto two = expect_orders<PushedPendulum<false>>("ida_order_index_2", exact);
  const auto one = expect_orders<PushedPendulum<true>>("ida_order_index_1", exact);
  for (int k = 0; k < 5; ++k) EXPECT_LT(two.finest[k].u, 2.0 * one.finest[k].u) << "order " << k + 1;
}

TEST(IdaOrder, ErrorFollowsTheTolerance) {
  const PushedAngle exact;
  tests::Table table("ida_tolerance_index_2",
                     {"rtol", "error of u", "error of p", "steps", "u over rtol", "p over rtol"});
  Error last{1.0, 1.0};
  for (const double rtol : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
    PushedPendulum<false> model;
    model.tolerances = {rtol, rtol, rtol, rtol, 10.0 * rtol};
    const SmallDae<PushedPendulum<false>> system(model);
    ida::Options options;
    options.rtol = rtol;
    ida::Ida integrator(system, options);
    std::vector<double> y(system.n), yp(system.n);
    system.initial_state(0.0, y, yp);
    integrator.start(0.0, y, yp);
    Error largest;
    core::Observer nobody;
    for (int i = 1; i <= 20; ++i) {
      integrator.advance(0.1 * i, nobody);
      const auto error = error_of(exact, integrator.current());
      largest.grow(error.u, error.p);
    }
    const auto steps = double(integrator.current().statistics.steps);
    table.row({rtol, largest.u, largest.p, steps, largest.u / rtol, largest.p / rtol});
    EXPECT_LT(largest.u, 100.0 * rtol) << rtol;
    EXPECT_LT(largest.u, last.u) << rtol;
    EXPECT_LT(largest.p, last.p) << rtol;
    last = largest;
  }
}

}  // namespace
