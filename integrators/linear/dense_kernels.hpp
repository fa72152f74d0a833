#pragma once

#include "linear/direct_solver.hpp"

/// Kernels on dense, column-major blocks, to be inlined into functions that are compiled for one processor or another.
#if defined(__x86_64__) && defined(__GNUC__)
/// Before a function that may use AVX2 and FMA, to be called where dense::has_fma() is true.
#define TALUS_FMA [[gnu::target("avx2,fma")]]
#endif

namespace talus::linear::dense {

#ifdef TALUS_FMA
inline bool has_fma() {
  static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has;
}
#endif

/// How many numbers stand side by side: registers of 32 bytes where there are such, parts of them elsewhere.
template <class Real>
constexpr int lanes = 32 / static_cast<int>(sizeof(Real));
template <class Real>
struct Lanes {
  using type [[gnu::vector_size(32), gnu::aligned(alignof(Real)), gnu::may_alias]] = Real;
};

/// C -= A B for a tile of n_vectors * lanes rows and n_columns columns.
template <class Real, int n_vectors, int n_columns>
[[gnu::always_inline]] inline void subtract_tile(Index k, const Real* A, Index lda, const Real* B, Index ldb, Real* C,
                                                 Index ldc) {
  using V = typename Lanes<Real>::type;
  V sum[n_columns][n_vectors];
  for (int j = 0; j < n_columns; ++j)
    for (int v = 0; v < n_vectors; ++v) sum[j][v] = *reinterpret_cast<const V*>(C + j * ldc + v * lanes<Real>);
  for (Index p = 0; p < k; ++p) {
    V a[n_vectors];
    for (int v = 0; v < n_vectors; ++v) a[v] = *reinterpret_cast<const V*>(A + p * lda + v * lanes<Real>);
    for (int j = 0; j < n_columns; ++j)
      for (int v = 0; v < n_vectors; ++v) sum[j][v] -= a[v] * B[j * ldb + p];
  }
  for (int j = 0; j < n_columns; ++j)
    for (int v = 0; v < n_vectors; ++v) *reinterpret_cast<V*>(C + j * ldc + v * lanes<Real>) = sum[j][v];
}

template <class Real, int n_columns>
[[gnu::always_inline]] inline void subtract_columns(Index m, Index k, const Real* A, Index lda, const Real* B,
                                                    Index ldb, Real* C, Index ldc) {
  constexpr int most = 3;  // with four columns, what sixteen registers hold
  Index i = 0;
  for (; i + most * lanes<Real> <= m; i += most * lanes<Real>)
    subtract_tile<Real, most, n_columns>(k, A + i, lda, B, ldb, C + i, ldc);
  for (; i + lanes<Real> <= m; i += lanes<Real>) subtract_tile<Real, 1, n_columns>(k, A + i, lda, B, ldb, C + i, ldc);
  for (; i < m; ++i)
    for (int j = 0; j < n_columns; ++j) {
      Real sum = C[i + j * ldc];
      for (Index p = 0; p < k; ++p) sum -= A[i + p * lda] * B[j * ldb + p];
      C[i + j * ldc] = sum;
    }
}

/// C -= A B, of shapes (m, n), (m, k), (k, n).
template <class Real>
[[gnu::always_inline]] inline void subtract_product(Index m, Index n, Index k, const Real* A, Index lda, const Real* B,
                                                    Index ldb, Real* C, Index ldc) {
  Index j = 0;
  for (; j + 4 <= n; j += 4) subtract_columns<Real, 4>(m, k, A, lda, B + j * ldb, ldb, C + j * ldc, ldc);
  for (; j < n; ++j) subtract_columns<Real, 1>(m, k, A, lda, B + j * ldb, ldb, C + j * ldc, ldc);
}

/// X <- L^-1 X, X of shape (m, n), L lower with ones on its diagonal, m <= lanes.
template <class Real>
[[gnu::always_inline]] inline void solve_small_lower(Index m, Index n, const Real* L, Index ldl, Real* X, Index ldx) {
  if (m == lanes<Real>) {
    using V = typename Lanes<Real>::type;
    V column[lanes<Real>]{};
    for (int p = 0; p < lanes<Real>; ++p)
      for (int i = p + 1; i < lanes<Real>; ++i) column[p][i] = L[i + p * ldl];
    for (Index j = 0; j < n; ++j) {
      V x = *reinterpret_cast<const V*>(X + j * ldx);
      for (int p = 0; p + 1 < lanes<Real>; ++p) x -= column[p] * x[p];
      *reinterpret_cast<V*>(X + j * ldx) = x;
    }
    return;
  }
  for (Index j = 0; j < n; ++j)
    for (Index p = 0; p < m; ++p)
      for (Index i = p + 1; i < m; ++i) X[i + j * ldx] -= L[i + p * ldl] * X[p + j * ldx];
}

/// X <- L^-1 X for any m.
template <class Real>
[[gnu::always_inline]] inline void solve_lower(Index m, Index n, const Real* L, Index ldl, Real* X, Index ldx) {
  for (Index s = 0; s < m; s += lanes<Real>) {
    const Index size = m - s < lanes<Real> ? m - s : Index{lanes<Real>}, rest = m - s - size;
    solve_small_lower(size, n, L + s + s * ldl, ldl, X + s, ldx);
    if (rest > 0) subtract_product(rest, n, size, L + s + size + s * ldl, ldl, X + s, ldx, X + s + size, ldx);
  }
}

/// X <- U^-1 X.
template <class Real>
[[gnu::always_inline]] inline void solve_upper(Index m, Index n, const Real* U, Index ldu, Real* X, Index ldx) {
  for (Index j = 0; j < n; ++j)
    for (Index p = m; p-- > 0;) {
      X[p + j * ldx] /= U[p + p * ldu];
      for (Index i = 0; i < p; ++i) X[i + j * ldx] -= U[i + p * ldu] * X[p + j * ldx];
    }
}

}  // namespace talus::linear::dense
