#include "ida/consistent_start.hpp"

#include <algorithm>
#include <cmath>

#include "ida/damped_newton.hpp"

namespace talus::ida {
namespace {

/// One implicit Euler step of size `step` from y0 to time t. Its unknown x is the change of y against the guess; for
/// differential unknowns y = y0 + step y', so y' is resolved beyond the rounding of y.
class EulerStep final : public NewtonProblem {
 public:
  /// y_0 and yp_guess are kept by reference.
  EulerStep(Equations& equations, double rtol, double t, double step, std::span<const double> y_0,
            std::span<const double> guess, std::span<const double> yp_guess)
      : equations_(equations),
        t_(t),
        step_(step),
        y_0_(y_0),
        guess_(guess),
        yp_guess_(yp_guess),
        y_(y_0.size()),
        yp_(y_0.size()) {
    const auto& layout = equations.system().layout();
    weights_.resize(y_0.size());
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      weights_[i] = 1.0 / (rtol * std::abs(guess[i]) + layout.field(static_cast<core::Index>(i)).absolute_tolerance);
      if (differential(i)) weights_[i] *= rate_emphasis;
    }
  }

  Outcome residual(std::span<const double> x, std::span<double> g) override {
    set(x);
    return equations_.residual(t_, y_, yp_, g);
  }
  Outcome refresh(std::span<const double> x) override {
    set(x);
    return equations_.refresh(t_, y_, yp_, 1.0 / step_);
  }
  Outcome solve(std::span<double> b) override { return equations_.solve(b); }
  [[nodiscard]] double product(std::span<const double> a, std::span<const double> b) const override {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * weights_[i] * b[i] * weights_[i];
    return sum / static_cast<double>(a.size());
  }
  [[nodiscard]] double drift() const override { return equations_.c_j() == 1.0 / step_ ? 0.0 : HUGE_VAL; }

  void weigh(std::span<double> v) const {
    for (std::size_t i = 0; i < v.size(); ++i) v[i] *= weights_[i];
  }

  /// y and y' at x; y' of algebraic unknowns is zero.
  void set(std::span<const double> x) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      yp_[i] = differential(i) ? yp_guess_[i] + x[i] / step_ : 0.0;
      y_[i] = differential(i) ? y_0_[i] + step_ * yp_[i] : guess_[i] + x[i];
    }
  }
  [[nodiscard]] std::span<const double> y() const { return y_; }
  [[nodiscard]] std::span<const double> yp() const { return yp_; }
  [[nodiscard]] bool differential(std::size_t i) const {
    return equations_.system().layout().field(static_cast<core::Index>(i)).kind == core::Kind::differential;
  }

 private:
  /// y' = change / step matters over times much longer than `step`: a change of a differential unknown counts this much
  /// more.
  static constexpr double rate_emphasis = 1e5;

  Equations& equations_;
  double t_, step_;
  std::span<const double> y_0_, guess_, yp_guess_;
  std::vector<double> y_, yp_, weights_;
};

}  // namespace

Outcome make_consistent(Equations& equations, const Options& options, double t, std::span<double> y,
                        std::span<double> yp, std::vector<double>& last_correction) {
  using Status = DampedNewton::Status;
  NewtonOptions how = options.newton;
  how.max_refreshes = 60;  // far from a solution, and no smaller step to fall back on
  how.max_iterations = 400;
  const auto solve = [&](EulerStep& step, std::size_t n) {
    DampedNewton newton(how);
    std::vector<double> x(n, 0.0);
    Status status = newton.solve(step, x, 1e-3);
    // The iteration may stall on rounding (of the constraints, magnified in y') after it has got as far as the error
    // test cares.
    if (status == Status::diverged && newton.correction_norm() < 1.0) status = Status::converged;
    if (status == Status::converged) step.set(x);
    last_correction.assign(newton.correction().begin(), newton.correction().end());
    step.weigh(last_correction);
    return status;
  };

  const bool constrained = std::ranges::any_of(
      equations.system().layout().fields, [](const core::Field& field) { return field.kind == core::Kind::algebraic; });
  Status status = Status::diverged;
  for (double size = options.start_step; size <= 1001.0 * options.start_step; size *= 10.0) {
    std::vector<double> guess(y.begin(), y.end()), on_constraints(y.begin(), y.end());
    if (constrained) {
      EulerStep projection(equations, options.rtol, t, size, y, y, yp);
      status = solve(projection, y.size());
      if (status == Status::broken) break;
      if (status != Status::converged) continue;
      for (std::size_t i = 0; i < y.size(); ++i) {
        if (projection.differential(i)) guess[i] = on_constraints[i] = projection.y()[i];
      }
    }
    EulerStep motion(equations, options.rtol, t + size, size, on_constraints, guess, yp);
    status = solve(motion, y.size());
    if (status == Status::broken) break;
    if (status != Status::converged) continue;
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] = motion.differential(i) ? on_constraints[i] : motion.y()[i];
      yp[i] = motion.yp()[i];
    }
    break;
  }
  equations.forget_factors();
  if (status == Status::converged) return Outcome::ok;
  return status == Status::broken ? Outcome::broken : Outcome::refused;
}

}  // namespace talus::ida
