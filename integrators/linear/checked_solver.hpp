#pragma once

#include "linear/direct_solver.hpp"

namespace talus::linear {

/// What the solvers share: each factorisation is proved by one solve with a known right side, and reused pivots that fail it are
/// given up; each solve is followed by its residual and, where that is above `refine_above`, by up to two steps of iterative
/// refinement. The relative residual is max |D (b - A x)| / max D (|A| |x| + |b|), D the reciprocal largest entry of each row.
class CheckedSolver : public DirectSolver {
 public:
  static constexpr double accept_below = 1e-8;   ///< of a test solve
  static constexpr double refine_above = 1e-12;  ///< of a solve

  explicit CheckedSolver(const SparsePattern& pattern);

  void factor(std::span<const double> values) final;
  void solve(std::span<double> b) final;
  [[nodiscard]] const Statistics& statistics() const final { return statistics_; }

 protected:
  /// Full factorisation with pivot search; records fill and flops. Throws SingularMatrix.
  virtual void factor_anew() = 0;
  /// Factorisation with the last pivots; false where there are none or they broke down.
  virtual bool refactor() { return false; }
  /// b <- (L U)^-1 b.
  virtual void substitute(std::span<double> b) = 0;

  /// Relative residual of a solve with a fixed pseudo-random right side; kept as statistics().test_residual.
  double prove();
  void record(Index fill, double flops) {
    statistics_.fill = fill;
    statistics_.flops = flops;
  }
  [[nodiscard]] const SparsePattern& pattern() const { return pattern_; }
  [[nodiscard]] std::span<const double> values() const { return values_; }
  /// Reciprocal of the largest entry of each row, shape n.
  [[nodiscard]] std::span<const double> row_scale() const { return row_scale_; }

 private:
  void scale_rows();
  double residual(std::span<const double> b, std::span<const double> x);

  const SparsePattern& pattern_;
  std::vector<double> values_, row_scale_;
  std::vector<double> b_, r_, size_;  // scratch of solve()
  Statistics statistics_;
};

}  // namespace talus::linear
