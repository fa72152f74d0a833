#include "ida/damped_newton.hpp"

#include <algorithm>
#include <cmath>

#include "core/sums.hpp"

namespace talus::ida {
namespace {

DampedNewton::Status failure(Outcome outcome) {
  return outcome == Outcome::broken ? DampedNewton::Status::broken : DampedNewton::Status::refused;
}

double remaining(double contraction) { return contraction < 1.0 ? contraction / (1.0 - contraction) : HUGE_VAL; }

}  // namespace

DampedNewton::Status DampedNewton::solve(NewtonProblem& problem, std::span<double> x, double tolerance) {
  for (auto* v : {&dx_, &g_, &step_, &trial_, &trial_dx_, &trial_g_}) v->resize(x.size());
  iterations_ = refreshes_ = 0;
  fresh_ = false;
  first_ = true;
  slow_ = 0;
  secants_.reweigh();
  count_doubt();
  if (const auto outcome = problem.residual(x, g_); outcome != Outcome::ok) return failure(outcome);
  g_start_ = g_;
  Status status = problem.drift() > options_.refresh_above ? renew(problem, x) : correct(problem);
  if (status != Status::converged) return status;

  double expected = fresh_ ? unknown : std::max(contraction_, problem.drift());
  while (true) {
    const bool done = close(expected, tolerance);
    if (done && settled(problem, expected)) return finish(x);
    if (iterations_ >= options_.max_iterations) return done ? finish(x) : Status::diverged;
    status = advance(problem, x, expected);
    // A residual that cannot be brought down further while even new factors want no more than the tolerance is rounding.
    if (status == Status::diverged && done && norm_ <= tolerance) return finish(x);
    if (status != Status::converged) return status;
    if (close(expected, tolerance)) continue;
    if (expected > options_.refresh_above) ++slow_;
    if (slow_ >= (doubt_ > 0 ? 1 : options_.slow_moves) && refreshes_ < options_.max_refreshes) {
      status = renew(problem, x);
      if (status != Status::converged) return status;
      // New factors contract as the old ones did, or better: `expected` still bounds what follows.
    }
  }
}

void DampedNewton::forget() {
  contraction_ = unknown;
  secants_.clear();
  doubt_ = doubt_again_ = options_.doubt;
  shortened_ = false;
}

/// At the start of a solve.
void DampedNewton::count_doubt() {
  constexpr int most = 1 << 20;
  if (shortened_) {
    doubt_again_ = doubt_ > 0 ? std::min(2 * doubt_again_, most) : options_.doubt;
    doubt_ = doubt_again_;
  } else if (doubt_ > 0) {
    --doubt_;
  }
  shortened_ = false;
}

/// Whether what is left after one more step is within the tolerance.
bool DampedNewton::close(double contraction, double tolerance) const {
  return remaining(contraction) * step_norm_ <= tolerance && remaining(contraction) * step_largest_ <= 1.0;
}

/// Whether the residual, after one more correction, is as small as doubt demands.
bool DampedNewton::settled(const NewtonProblem& problem, double contraction) const {
  return doubt_ == 0 || contraction * problem.share_left(g_, g_start_) <= options_.residual_share;
}

/// The last correction is made without another look.
DampedNewton::Status DampedNewton::finish(std::span<double> x) {
  ++iterations_;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += step_[i];
  return Status::converged;
}

/// New factors at x, where the residual is g_, and the correction they give.
DampedNewton::Status DampedNewton::renew(NewtonProblem& problem, std::span<const double> x) {
  ++refreshes_;
  if (const auto outcome = problem.refresh(x); outcome != Outcome::ok) return failure(outcome);
  fresh_ = true;
  contraction_ = unknown;
  slow_ = 0;
  secants_.clear();
  return correct(problem);
}

void DampedNewton::accelerate(const NewtonProblem& problem) {
  secants_.set_scale(problem.scale());
  secants_.accelerate([&](auto a, auto b) { return problem.product(a, b); }, dx_, step_);
  step_norm_ = secants_.empty() ? norm_ : std::sqrt(problem.product(step_, step_));
  step_largest_ = problem.largest(step_);
}

/// dx_ = -J^-1 g_ and its norm, and the step that follows.
DampedNewton::Status DampedNewton::correct(NewtonProblem& problem) {
  const auto status = correct(problem, g_, dx_, norm_);
  if (status == Status::converged) accelerate(problem);
  return status;
}

/// dx = -J^-1 g and its norm.
DampedNewton::Status DampedNewton::correct(NewtonProblem& problem, std::span<const double> g, std::vector<double>& dx,
                                           double& norm) {
  core::in_halves(g.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) dx[i] = -g[i];
  });
  if (const auto outcome = problem.solve(dx); outcome != Outcome::ok) return failure(outcome);
  norm = std::sqrt(problem.product(dx, dx));
  return std::isfinite(norm) ? Status::converged : Status::diverged;
}

/// Ratio of corrections up to which a trial is accepted.
double DampedNewton::most_growth(double lambda) const {
  const bool may_grow = lambda == 1.0 && doubt_ == 0 && !fresh_ && refreshes_ < options_.max_refreshes;
  return may_grow ? options_.growth : 1.0 - 0.25 * lambda;
}

/// One accepted move x += lambda step_; on return dx_, norm_ and step_ are the next correction and step, g_ the
/// residual at the new x, and `contraction` is what the move achieved.
DampedNewton::Status DampedNewton::advance(NewtonProblem& problem, std::span<double> x, double& contraction) {
  double lambda = 1.0;
  auto last = Status::diverged;
  for (int halvings = 0; halvings <= options_.max_halvings;) {
    ++iterations_;
    core::in_halves(x.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) trial_[i] = x[i] + lambda * step_[i];
    });
    const auto outcome = problem.residual(trial_, trial_g_);
    if (outcome == Outcome::broken) return Status::broken;
    if (outcome == Outcome::ok) {
      double norm = 0.0;
      const auto status = correct(problem, trial_g_, trial_dx_, norm);
      if (status == Status::broken) return status;
      if (status == Status::converged && norm <= most_growth(lambda) * norm_) {
        contraction = lambda == 1.0 ? std::max(norm / norm_, least) : unknown;
        if (first_) contraction_ = contraction;
        first_ = false;
        std::copy(trial_.begin(), trial_.end(), x.begin());
        std::swap(g_, trial_g_);
        std::swap(dx_, trial_dx_);
        norm_ = norm;
        secants_.add(lambda, step_, trial_dx_, dx_);
        accelerate(problem);
        fresh_ = false;
        return Status::converged;
      }
    }
    last = outcome == Outcome::refused ? Status::refused : Status::diverged;
    if (!fresh_ && refreshes_ < options_.max_refreshes) {
      const auto status = renew(problem, x);
      if (status != Status::converged) return status;
    } else {
      lambda *= 0.5;
      shortened_ = true;
      ++halvings;
    }
  }
  return last;
}

}  // namespace talus::ida
