#pragma once

#include <algorithm>

#include "linear/direct_solver.hpp"

namespace talus::linear {

/// What the solvers share. Each solve is followed by its residual and, where that is above full_accuracy, by up to two steps of
/// iterative refinement. The first solve of a factorisation is also its test: one that fails is done anew, with new pivots.
/// The relative residual is max |D (b - A x)| / max D (|A| |x| + |b|), D the reciprocal largest entry of each row.
///
/// Coarse factors, made for less accuracy, are tested twice by their first solve: by its residual, and by how much a solve for
/// that residual changes it (a small residual proves nothing where A is nearly singular). Their other solves are taken as
/// they come.
class CheckedSolver : public DirectSolver {
 public:
  static constexpr double accept_below = 1e-8;  ///< relative residual of a first solve

  explicit CheckedSolver(const SparsePattern& pattern);

  static constexpr double trust_below = 1e-3;  ///< error of a first solve with coarse factors

  /// The relative residual that coarse factors must reach, full_accuracy unless said; see Settings.
  void demand(double accuracy) { accuracy_ = accuracy; }
  /// Whether a first solve with that relative residual shows the factors to be good.
  [[nodiscard]] bool acceptable(double residual) const {
    return residual < (coarse() ? std::max(accept_below, accept_coarse_below()) : accept_below);
  }

  void factor(std::span<const double> values) final;
  void solve(std::span<double> b) final;
  [[nodiscard]] const Statistics& statistics() const final { return statistics_; }

  /// Relative residual of a solve with a fixed pseudo-random right side, before refinement; infinite where it is not
  /// finite.
  double prove();

 protected:
  /// Full factorisation with pivot search; records fill and flops. Throws SingularMatrix.
  virtual void factor_anew() = 0;
  /// Factorisation with the last pivots; false where there are none or they broke down.
  virtual bool refactor() { return false; }
  /// b <- (L U)^-1 b.
  virtual void substitute(std::span<double> b) = 0;

  void record(Index fill, double flops) {
    statistics_.fill = fill;
    statistics_.flops = flops;
  }
  /// Whether the factors at hand are made for less than full accuracy.
  [[nodiscard]] virtual bool coarse() const { return false; }
  /// Relative residual of a first solve with coarse factors.
  [[nodiscard]] virtual double accept_coarse_below() const { return accuracy_; }
  [[nodiscard]] double accuracy() const { return accuracy_; }
  /// Whether the factors of this matrix failed their test before.
  [[nodiscard]] bool rejected() const { return rejected_; }
  [[nodiscard]] const SparsePattern& pattern() const { return pattern_; }
  [[nodiscard]] std::span<const double> values() const { return values_; }
  /// Reciprocal of the largest entry of each row, shape n.
  [[nodiscard]] std::span<const double> row_scale() const { return row_scale_; }

 private:
  void scale_rows();
  double residual(std::span<const double> b, std::span<const double> x);
  double error_in(std::span<const double> b);

  const SparsePattern& pattern_;
  double accuracy_ = full_accuracy;
  std::vector<double> values_, row_scale_;
  bool rejected_ = false;
  bool first_ = false;                    // the first solve with the factors is still to come
  std::vector<double> b_, r_, size_, x_;  // scratch of solve()
  Statistics statistics_;
};

}  // namespace talus::linear
