#include "linear/mumps_solver.hpp"

#include <dmumps_c.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace talus::linear {

MumpsSolver::MumpsSolver(const SparsePattern& matrix)
    : CheckedSolver(matrix), column_scale_(matrix.n()), scratch_single_(matrix.n()), scratch_(matrix.n()) {}

void MumpsSolver::factor_anew() {
  scale_columns();
  in_single_ = accuracy() >= single_precision && !rejected();
  if (in_single_) {
    try {
      factor_in(single_);
    } catch (const SingularMatrix&) { in_single_ = false; }
  }
  if (!in_single_) factor_in(double_);
}

void MumpsSolver::scale_columns() {
  const auto starts = pattern().column_starts();
  const auto rows = pattern().rows();
  for (Index j = 0; j < pattern().n(); ++j) {
    double most = 0.0;
    for (Index k = starts[j]; k < starts[j + 1]; ++k)
      most = std::max(most, std::abs(values()[k]) * row_scale()[rows[k]]);
    if (most == 0.0) throw SingularMatrix("column " + std::to_string(j) + " of the matrix is zero", j);
    column_scale_[j] = 1.0 / most;
  }
}

template <class Real>
void MumpsSolver::factor_in(std::unique_ptr<MumpsFactors<Real>>& factors) {
  if (!factors) factors = std::make_unique<MumpsFactors<Real>>(pattern());
  const auto starts = pattern().column_starts();
  const auto rows = pattern().rows();
  const auto scaled = factors->values();
  for (Index j = 0; j < pattern().n(); ++j)
    for (Index k = starts[j]; k < starts[j + 1]; ++k)
      scaled[k] = static_cast<Real>(values()[k] * row_scale()[rows[k]] * column_scale_[j]);
  factors->factor();
  record(factors->fill(), factors->flops());
}

void MumpsSolver::substitute(std::span<double> b) {
  if (in_single_) substitute_in(*single_, scratch_single_, b);
  else substitute_in(*double_, scratch_, b);
}

/// The right side is brought to a largest entry of one: single precision reaches from 1e-38 to 1e38 only.
template <class Real>
void MumpsSolver::substitute_in(MumpsFactors<Real>& factors, std::vector<Real>& scratch, std::span<double> b) const {
  double most = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) most = std::max(most, std::abs(b[i] * row_scale()[i]));
  const double size = most > 0.0 && std::isfinite(most) ? std::exp2(std::ilogb(most)) : 1.0;
  for (std::size_t i = 0; i < b.size(); ++i) scratch[i] = static_cast<Real>(b[i] * row_scale()[i] / size);
  factors.substitute(scratch);
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = static_cast<double>(scratch[i]) * column_scale_[i] * size;
}

std::string MumpsSolver::describe() const {
  std::ostringstream line;
  line << "MUMPS version " << MUMPS_VERSION << ", METIS";
  if (single_ || double_)
    line << ", in " << (in_single_ ? "single" : "double") << " precision, fill " << statistics().fill << ", residual "
         << statistics().first_residual;
  return line.str();
}

}  // namespace talus::linear
