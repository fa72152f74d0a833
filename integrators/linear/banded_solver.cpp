#include "linear/banded_solver.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "linear/ordering.hpp"

extern "C" {
void dgbtrf_(const int* m, const int* n, const int* kl, const int* ku, double* ab, const int* ldab, int* ipiv,
             int* info);
void dgbtrs_(const char* trans, const int* n, const int* kl, const int* ku, const int* nrhs, const double* ab,
             const int* ldab, const int* ipiv, double* b, const int* ldb, int* info, std::size_t trans_length);
}

namespace talus::linear {

BandedSolver::BandedSolver(const SparsePattern& matrix, std::vector<Index> ordering) : CheckedSolver(matrix) {
  if (matrix.n() > std::numeric_limits<int>::max())
    throw std::invalid_argument("BandedSolver: too many unknowns for LAPACK");
  if (!ordering.empty()) {
    name_ = "given";
    order_ = std::move(ordering);
  } else {
    name_ = "natural";
    order_ = natural_ordering(matrix.n());
    auto other = reverse_cuthill_mckee(matrix);
    if (bandwidth(matrix, other).work() < bandwidth(matrix, order_).work()) {
      name_ = "reverse Cuthill-McKee";
      order_ = std::move(other);
    }
  }
  place_ = inverse(order_);
  const Bandwidth width = bandwidth(matrix, order_);
  lower_ = width.lower;
  upper_ = width.upper;
  scratch_.resize(matrix.n());
  pivots_.resize(matrix.n());
}

std::size_t BandedSolver::memory() const {
  return sizeof(double) * static_cast<std::size_t>(leading() * pattern().n());
}

double BandedSolver::flops_bound() const {
  return 2.0 * static_cast<double>(pattern().n()) * static_cast<double>(lower_) *
         static_cast<double>(lower_ + upper_ + 1);
}

void BandedSolver::factor_anew() {
  const auto starts = pattern().column_starts();
  const auto rows = pattern().rows();
  const Index width = leading();
  band_.assign(width * pattern().n(), 0.0);
  for (Index j = 0; j < pattern().n(); ++j) {
    double* diagonal = band_.data() + place_[j] * width + lower_ + upper_;
    for (Index k = starts[j]; k < starts[j + 1]; ++k) {
      diagonal[place_[rows[k]] - place_[j]] = values()[k] * row_scale()[rows[k]];
    }
  }
  const int n = static_cast<int>(pattern().n()), kl = static_cast<int>(lower_), ku = static_cast<int>(upper_);
  const int ldab = static_cast<int>(width);
  int info = 0;
  dgbtrf_(&n, &n, &kl, &ku, band_.data(), &ldab, pivots_.data(), &info);
  if (info != 0) throw SingularMatrix("LAPACK dgbtrf: the matrix is singular", info > 0 ? order_[info - 1] : -1);
  record(pattern().n() * (2 * lower_ + upper_ + 1), flops_bound());
}

void BandedSolver::substitute(std::span<double> b) {
  for (std::size_t k = 0; k < scratch_.size(); ++k) scratch_[k] = b[order_[k]] * row_scale()[order_[k]];
  const int n = static_cast<int>(pattern().n()), kl = static_cast<int>(lower_), ku = static_cast<int>(upper_);
  const int ldab = static_cast<int>(leading()), one = 1;
  int info = 0;
  dgbtrs_("N", &n, &kl, &ku, &one, band_.data(), &ldab, pivots_.data(), scratch_.data(), &n, &info, 1);
  for (std::size_t k = 0; k < scratch_.size(); ++k) b[order_[k]] = scratch_[k];
}

std::string BandedSolver::describe() const {
  std::ostringstream line;
  line << "LAPACK band LU, ordering " << name_ << ", " << lower_ << " + " << upper_ << " diagonals, "
       << memory() / (1 << 20) << " MiB";
  if (statistics().factorisations > 0) line << ", residual " << statistics().first_residual;
  return line.str();
}

}  // namespace talus::linear
