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
  const bool symmetric = strategy == Strategy::symmetric;
  control_[UMFPACK_STRATEGY] = symmetric ? UMFPACK_STRATEGY_SYMMETRIC : UMFPACK_STRATEGY_UNSYMMETRIC;
  control_[UMFPACK_SYM_PIVOT_TOLERANCE] = 0.1;
  control_[UMFPACK_IRSTEP] = 0;
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
  line << "UMFPACK " << UMFPACK_MAIN_VERSION << '.' << UMFPACK_SUB_VERSION << '.' << UMFPACK_SUBSUB_VERSION
       << (strategy_ == Strategy::symmetric ? ", symmetric" : ", unsymmetric") << " strategy";
  if (numeric_ != nullptr) line << ", fill " << statistics().fill << ", residual " << statistics().first_residual;
  return line.str();
}

}  // namespace talus::linear
