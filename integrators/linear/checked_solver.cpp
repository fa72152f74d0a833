#include "linear/checked_solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/sums.hpp"

namespace talus::linear {
namespace {

SingularMatrix not_finite() { return {"the factors give a solution that is not finite", -1}; }

}  // namespace

CheckedSolver::CheckedSolver(const SparsePattern& pattern)
    : pattern_(pattern),
      values_(pattern.n_nonzeros()),
      row_scale_(pattern.n()),
      b_(pattern.n()),
      r_(pattern.n()),
      size_(pattern.n()),
      x_(pattern.n()) {}

void CheckedSolver::factor(std::span<const double> values) {
  if (values.size() != values_.size())
    throw std::invalid_argument("CheckedSolver::factor: one value an entry of the pattern");
  core::in_halves(values.size(), [&](std::size_t begin, std::size_t end) {
    std::copy(values.begin() + begin, values.begin() + end, values_.begin() + begin);
  });
  scale_rows();
  ++statistics_.factorisations;
  first_ = true;
  rejected_ = false;
  if (refactor()) ++statistics_.refactorisations;
  else factor_anew();
}

void CheckedSolver::solve(std::span<double> b) {
  ++statistics_.solves;
  std::copy(b.begin(), b.end(), b_.begin());
  substitute(b);
  if (!first_ && coarse()) {
    if (!core::all_finite(b)) throw not_finite();
    return;
  }
  double size = residual(b_, b);
  if (first_ && !(acceptable(size) && (!coarse() || error_in(b) < trust_below))) {
    ++statistics_.rejected;
    rejected_ = true;
    factor_anew();
    std::copy(b_.begin(), b_.end(), b.begin());
    substitute(b);
    size = residual(b_, b);
  }
  if (first_) statistics_.first_residual = size;
  first_ = first_ && size == 0.0;  // a zero right side proves nothing
  for (int step = 0; step < 2 && size > (coarse() ? accuracy_ : full_accuracy) && std::isfinite(size); ++step) {
    ++statistics_.refinements;
    std::copy(r_.begin(), r_.end(), x_.begin());
    substitute(x_);
    for (std::size_t i = 0; i < b.size(); ++i) x_[i] += b[i];
    const double refined = residual(b_, x_);
    if (!(refined < size)) break;
    size = refined;
    std::copy(x_.begin(), x_.end(), b.begin());
  }
  if (!std::isfinite(size)) throw not_finite();
  statistics_.worst_residual = std::max(statistics_.worst_residual, size);
}

void CheckedSolver::scale_rows() {
  std::fill(row_scale_.begin(), row_scale_.end(), 0.0);
  const auto rows = pattern_.rows();
  for (std::size_t k = 0; k < values_.size(); ++k) {
    if (!std::isfinite(values_[k])) throw SingularMatrix("an entry of the matrix is not finite", -1);
    row_scale_[rows[k]] = std::max(row_scale_[rows[k]], std::abs(values_[k]));
  }
  for (std::size_t i = 0; i < row_scale_.size(); ++i) {
    if (row_scale_[i] == 0.0)
      throw SingularMatrix("row " + std::to_string(i) + " of the matrix is zero", static_cast<Index>(i));
    row_scale_[i] = 1.0 / row_scale_[i];
  }
}

/// How much of b, a solution whose residual is r_, another solve wants to change: of the root mean square, each unknown by the
/// largest entry of its column.
double CheckedSolver::error_in(std::span<const double> b) {
  std::copy(r_.begin(), r_.end(), x_.begin());
  substitute(x_);
  const auto starts = pattern_.column_starts();
  const auto rows = pattern_.rows();
  double change = 0.0, whole = 0.0;
  for (Index j = 0; j < pattern_.n(); ++j) {
    double most = 0.0;
    for (Index k = starts[j]; k < starts[j + 1]; ++k) most = std::max(most, std::abs(values_[k]) * row_scale_[rows[k]]);
    change += std::pow(most * x_[j], 2);
    whole += std::pow(most * b[j], 2);
  }
  return whole > 0.0 ? std::sqrt(change / whole) : 0.0;
}

double CheckedSolver::prove() {
  // A fixed pseudo-random right side, as large in each row as the matrix: it leaves no part of the factors untested.
  std::uint64_t state = 1;
  for (std::size_t i = 0; i < b_.size(); ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    b_[i] = (static_cast<double>(state >> 11) * 0x1p-52 - 1.0) / row_scale_[i];
  }
  std::copy(b_.begin(), b_.end(), x_.begin());
  substitute(x_);
  return residual(b_, x_);
}

double CheckedSolver::residual(std::span<const double> b, std::span<const double> x) {
  const auto starts = pattern_.column_starts();
  const auto rows = pattern_.rows();
  for (std::size_t i = 0; i < b.size(); ++i) {
    r_[i] = b[i];
    size_[i] = std::abs(b[i]);
  }
  for (Index j = 0; j < pattern_.n(); ++j) {
    for (Index k = starts[j]; k < starts[j + 1]; ++k) {
      const double term = values_[k] * x[j];
      r_[rows[k]] -= term;
      size_[rows[k]] += std::abs(term);
    }
  }
  double error = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!std::isfinite(r_[i])) return HUGE_VAL;
    error = std::max(error, std::abs(r_[i]) * row_scale_[i]);
    scale = std::max(scale, size_[i] * row_scale_[i]);
  }
  return scale > 0.0 ? error / scale : 0.0;
}

}  // namespace talus::linear
