#pragma once

#include <cstddef>

/// The routines of LAPACK and BLAS that this room calls, in double and single precision under one name. Arguments as theirs;
/// `info` is returned.
extern "C" {
void dgbtrf_(const int* m, const int* n, const int* kl, const int* ku, double* ab, const int* ldab, int* ipiv,
             int* info);
void sgbtrf_(const int* m, const int* n, const int* kl, const int* ku, float* ab, const int* ldab, int* ipiv,
             int* info);
void dgbtrs_(const char* trans, const int* n, const int* kl, const int* ku, const int* nrhs, const double* ab,
             const int* ldab, const int* ipiv, double* b, const int* ldb, int* info, std::size_t trans_length);
void sgbtrs_(const char* trans, const int* n, const int* kl, const int* ku, const int* nrhs, const float* ab,
             const int* ldab, const int* ipiv, float* b, const int* ldb, int* info, std::size_t trans_length);
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
void sgetrf_(const int* m, const int* n, float* a, const int* lda, int* ipiv, int* info);
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda, const int* ipiv,
             double* b, const int* ldb, int* info, std::size_t trans_length);
void sgetrs_(const char* trans, const int* n, const int* nrhs, const float* a, const int* lda, const int* ipiv,
             float* b, const int* ldb, int* info, std::size_t trans_length);
}

namespace talus::linear::lapack {

/// LU of an n x n band of kl and ku diagonals.
template <class Real>
int factor_band(int n, int kl, int ku, Real* band, int leading, int* pivots) {
  int info = 0;
  if constexpr (sizeof(Real) == sizeof(float)) sgbtrf_(&n, &n, &kl, &ku, band, &leading, pivots, &info);
  else dgbtrf_(&n, &n, &kl, &ku, band, &leading, pivots, &info);
  return info;
}

/// b <- A^-1 b with those factors, b of shape (n, m), column major.
template <class Real>
void solve_band(int n, int kl, int ku, int m, const Real* band, int leading, const int* pivots, Real* b) {
  int info = 0;
  if constexpr (sizeof(Real) == sizeof(float)) sgbtrs_("N", &n, &kl, &ku, &m, band, &leading, pivots, b, &n, &info, 1);
  else dgbtrs_("N", &n, &kl, &ku, &m, band, &leading, pivots, b, &n, &info, 1);
}

/// LU of a dense n x n matrix.
template <class Real>
int factor_dense(int n, Real* a, int* pivots) {
  int info = 0;
  if constexpr (sizeof(Real) == sizeof(float)) sgetrf_(&n, &n, a, &n, pivots, &info);
  else dgetrf_(&n, &n, a, &n, pivots, &info);
  return info;
}

/// b <- A^-1 b with those factors, b of shape n.
template <class Real>
void solve_dense(int n, const Real* a, const int* pivots, Real* b) {
  const int one = 1;
  int info = 0;
  if constexpr (sizeof(Real) == sizeof(float)) sgetrs_("N", &n, &one, a, &n, pivots, b, &n, &info, 1);
  else dgetrs_("N", &n, &one, a, &n, pivots, b, &n, &info, 1);
}

}  // namespace talus::linear::lapack
