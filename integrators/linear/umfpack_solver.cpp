#include "linear/umfpack_solver.hpp"

#include <umfpack.h>

#include <array>
#include <new>
#include <sstream>

#include "linear/memory_limit.hpp"

namespace talus::linear {

static_assert(sizeof(SuiteSparse_long) == sizeof(Index));

UmfpackSolver::UmfpackSolver(const SparsePattern& matrix, Strategy strategy)
    : CheckedSolver(matrix), strategy_(strategy), control_(UMFPACK_CONTROL) {
  umfpack_dl_defaults(control_.data());
  const bool symmetric = strategy != Strategy::unsymmetric;
  control_[UMFPACK_STRATEGY] = symmetric ? UMFPACK_STRATEGY_SYMMETRIC : UMFPACK_STRATEGY_UNSYMMETRIC;
  // Rows with a single entry, off the diagonal, make UMFPACK drop the symmetric strategy without a word.
  if (symmetric) control_[UMFPACK_SINGLETONS] = 0.0;
  if (strategy == Strategy::dissected) control_[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
  control_[UMFPACK_SYM_PIVOT_TOLERANCE] = 0.1;
  control_[UMFPACK_IRSTEP] = 0;
}

std::string UmfpackSolver::name(Strategy strategy) {
  switch (strategy) {
    case Strategy::symmetric: return "UMFPACK symmetric";
    case Strategy::dissected: return "UMFPACK dissected";
    case Strategy::unsymmetric: break;
  }
  return "UMFPACK unsymmetric";
}

UmfpackSolver::~UmfpackSolver() {
  umfpack_dl_free_numeric(&numeric_);
  umfpack_dl_free_symbolic(&symbolic_);
}

void UmfpackSolver::factor_anew() {
  const auto* starts = pattern().column_starts().data();
  const auto* rows = pattern().rows().data();
  std::array<double, UMFPACK_INFO> info{};
  umfpack_dl_free_numeric(&numeric_);
  SuiteSparse_long status = UMFPACK_OK;
  if (symbolic_ == nullptr) {
    status = umfpack_dl_symbolic(pattern().n(), pattern().n(), starts, rows, nullptr, &symbolic_, control_.data(),
                                 info.data());
  }
  if (status == UMFPACK_OK) {
    status = umfpack_dl_numeric(starts, rows, values().data(), symbolic_, &numeric_, control_.data(), info.data());
  }
  if (status == UMFPACK_OK) {
    record(static_cast<Index>(info[UMFPACK_LNZ] + info[UMFPACK_UNZ]), info[UMFPACK_FLOPS]);
  } else if (status == UMFPACK_WARNING_singular_matrix) {
    throw SingularMatrix("UMFPACK: the matrix is singular", -1);
  } else if (status == UMFPACK_ERROR_out_of_memory && !MemoryLimit::refused()) {
    throw std::bad_alloc();
  } else {
    throw SingularMatrix("UMFPACK: no factors, status " + std::to_string(status), -1);
  }
}

void UmfpackSolver::substitute(std::span<double> b) {
  const std::vector<double> right_side(b.begin(), b.end());
  const auto status =
      umfpack_dl_solve(UMFPACK_A, pattern().column_starts().data(), pattern().rows().data(), values().data(), b.data(),
                       right_side.data(), numeric_, control_.data(), nullptr);
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
}

std::string UmfpackSolver::describe() const {
  std::ostringstream line;
  line << name(strategy_) << " strategy, version " << UMFPACK_MAIN_VERSION << '.' << UMFPACK_SUB_VERSION << '.'
       << UMFPACK_SUBSUB_VERSION;
  if (numeric_ != nullptr) line << ", fill " << statistics().fill << ", residual " << statistics().first_residual;
  return line.str();
}

}  // namespace talus::linear
