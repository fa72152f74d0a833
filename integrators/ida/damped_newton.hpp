#pragma once

#include <span>
#include <vector>

#include "bridge/equations.hpp"
#include "ida/options.hpp"
#include "ida/secants.hpp"

namespace talus::ida {

using bridge::Outcome;

/// One system G(x) = 0 as Newton's method sees it.
class NewtonProblem {
 public:
  virtual ~NewtonProblem() = default;
  virtual Outcome residual(std::span<const double> x, std::span<double> g) = 0;
  /// New factors of the Jacobian at x.
  virtual Outcome refresh(std::span<const double> x) = 0;
  /// b <- (approximate Jacobian)^-1 b with the factors at hand.
  virtual Outcome solve(std::span<double> b) = 0;
  /// Factor that solve() gives its answer besides, the same throughout one solve of the system with one set of factors.
  [[nodiscard]] virtual double scale() const { return 1.0; }
  /// The weighted inner product of which the norm is the root.
  [[nodiscard]] virtual double product(std::span<const double> a, std::span<const double> b) const = 0;
  /// The largest component of `v` over what may be left of it in one unknown. 0, as by default: the norm alone decides.
  [[nodiscard]] virtual double largest(std::span<const double> /*v*/) const { return 0.0; }
  /// How much of the residual `g_start` is left in `g`: the largest share over groups of rows in one unit, a group at its
  /// rounding level counting as nothing. 0, as by default: corrections alone decide.
  [[nodiscard]] virtual double share_left(std::span<const double> /*g*/, std::span<const double> /*g_start*/) const {
    return 0.0;
  }
  /// Contraction to expect from what changed, apart from x, since the factors were made; 1 or more: useless or none at
  /// hand.
  [[nodiscard]] virtual double drift() const = 0;
};

/// Newton's method with a Jacobian that is kept while it contracts, accelerated by secants, with a natural monotonicity test.
///
/// The correction dx = -J^-1 G(x) becomes a step s by what the moves before showed (Secants): those of earlier solves too, as
/// long as the factors stay, because what the old J lacks hardly changes from one time step to the next. The trial
/// x + lambda s is accepted if the next correction, with the same J, is smaller. If it is not: first a stale J is
/// renewed, then lambda is halved. With a stale J a trial may be somewhat worse (`growth`): it makes a secant, and the next
/// step is better for it. After `slow_moves` moves in one solve that contracted by no more than `refresh_above`, J is renewed
/// at the new x. The iteration ends when contraction/(1 - contraction) times the last step is below the tolerance, and in no
/// unknown above its own bound (NewtonProblem::largest); the contraction is the ratio of the last two corrections, and at the
/// beginning of a solve that of the solve before.
///
/// In doubt, no trial may be worse, one slow move renews J, and the residual must also have fallen to `residual_share` of
/// what it was at the start of the solve. A system that is stiff here and soft beside it (a yielding material) needs that: with factors of the stiff state a large residual makes a
/// correction far below the tolerance, and what it leaves behind starts the next solve outside the stiff state. In doubt
/// are the first `doubt` solves, and as many after a step had to be shortened; twice as many each time that this happens in
/// doubt.
/// (P. Deuflhard, Newton Methods for Nonlinear Problems, 2004, sections 2.1.2 and 3.3.)
class DampedNewton {
 public:
  enum class Status { converged, diverged, refused, broken };

  explicit DampedNewton(const NewtonOptions& options) : options_(options), secants_(options.depth) {}

  /// Improves x (shape n) until the weighted error is below `tolerance`.
  Status solve(NewtonProblem& problem, std::span<double> x, double tolerance);
  /// Of the last solve().
  [[nodiscard]] int iterations() const { return iterations_; }
  /// The last correction of the last solve(), shape n.
  [[nodiscard]] std::span<const double> correction() const { return dx_; }
  [[nodiscard]] double correction_norm() const { return norm_; }
  /// Forgets what was learned, for example after the factors were used elsewhere.
  void forget();

 private:
  /// Assumed before a contraction is measured: the error is 20 times the correction.
  static constexpr double unknown = 20.0 / 21.0;
  /// No contraction is trusted below this: the next move may be accelerated less well than the last.
  static constexpr double least = 0.1;

  [[nodiscard]] bool close(double contraction, double tolerance) const;
  [[nodiscard]] bool settled(const NewtonProblem& problem, double contraction) const;
  void count_doubt();
  Status finish(std::span<double> x);
  Status renew(NewtonProblem& problem, std::span<const double> x);
  Status correct(NewtonProblem& problem);
  Status correct(NewtonProblem& problem, std::span<const double> g, std::vector<double>& dx, double& norm);
  void accelerate(const NewtonProblem& problem);
  [[nodiscard]] double most_growth(double lambda) const;
  Status advance(NewtonProblem& problem, std::span<double> x, double& contraction);

  NewtonOptions options_;
  double contraction_ = unknown;  ///< by the first move of the last solve that made one, with the factors at hand
  double norm_ = 0.0;             ///< of dx_
  double step_norm_ = 0.0;        ///< of step_
  double step_largest_ = 0.0;     ///< of step_, by NewtonProblem::largest
  int iterations_ = 0, refreshes_ = 0;
  int slow_ = 0;            ///< moves of this solve that contracted by no more than refresh_above
  bool fresh_ = false;      ///< the factors were made at the present x
  bool first_ = true;       ///< no move was made in this solve
  bool shortened_ = false;  ///< a step was, in the last solve or this one
  int doubt_ = options_.doubt,
      doubt_again_ = options_.doubt;  ///< solves in doubt that are left, and that a doubt brings
  std::vector<double> g_start_;       // residual where the solve began
  std::vector<double> dx_, g_;        // correction and residual at the present x
  std::vector<double> step_;          // dx_, accelerated
  Secants secants_;
  std::vector<double> trial_, trial_dx_, trial_g_;
};

}  // namespace talus::ida
