#include "linear/blas.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <new>

extern "C" {
// Of OpenBLAS; null with any other BLAS.
int openblas_get_parallel() __attribute__((weak));
void openblas_set_num_threads(int n) __attribute__((weak));

void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);

void sgemv_(const char* trans, const int* m, const int* n, const float* alpha, const float* a, const int* lda,
            const float* x, const int* incx, const float* beta, float* y, const int* incy);
void strsv_(const char* uplo, const char* trans, const char* diag, const int* n, const float* a, const int* lda,
            float* x, const int* incx);
}

namespace {

using Sgemm = void(const char*, const char*, const int*, const int*, const int*, const float*, const float*, const int*,
                   const float*, const int*, const float*, float*, const int*);
using Strsm = void(const char*, const char*, const char*, const char*, const int*, const int*, const float*,
                   const float*, const int*, float*, const int*);

/// The routine of that name that BLAS has.
template <class Routine>
Routine* of_blas(const char* name) {
  return reinterpret_cast<Routine*>(dlsym(RTLD_NEXT, name));
}

bool is(const char* given, char upper) { return (*given & ~0x20) == upper; }

}  // namespace

/// MUMPS substitutes a single right side as a matrix of one column, for which OpenBLAS before 0.3.27 packs the whole factor. These two
/// stand before those of BLAS in the search for symbols, pass one column on as a vector, and all else as it comes.
extern "C" {

__attribute__((visibility("default"))) void sgemm_(const char* trans_a, const char* trans_b, const int* m, const int* n,
                                                   const int* k, const float* alpha, const float* a, const int* lda,
                                                   const float* b, const int* ldb, const float* beta, float* c,
                                                   const int* ldc) {
  static Sgemm* const whole = of_blas<Sgemm>("sgemm_");
  constexpr int one = 1;
  if (*n != 1) return whole(trans_a, trans_b, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc);
  const bool plain = is(trans_a, 'N');
  if (*beta == 0.0F) std::fill_n(c, *m, 0.0F);  // whatever was there
  sgemv_(trans_a, plain ? m : k, plain ? k : m, alpha, a, lda, b, is(trans_b, 'N') ? &one : ldb, beta, c, &one);
}

__attribute__((visibility("default"))) void strsm_(const char* side, const char* uplo, const char* trans_a,
                                                   const char* diag, const int* m, const int* n, const float* alpha,
                                                   const float* a, const int* lda, float* b, const int* ldb) {
  static Strsm* const whole = of_blas<Strsm>("strsm_");
  constexpr int one = 1;
  if (*n != 1 || !is(side, 'L') || *alpha != 1.0F) return whole(side, uplo, trans_a, diag, m, n, alpha, a, lda, b, ldb);
  strsv_(uplo, trans_a, diag, m, a, lda, b, &one);
}
}

namespace talus::linear {

void limit_blas_to_one_thread() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

void reserve_blas_work_space() {
  if (openblas_get_parallel == nullptr) return;
  static const bool reserved = [] {
    constexpr std::size_t bytes = 128 * 1024 * 1024;  // what Debian's OpenBLAS 0.3.21 takes of the address space
    ::operator delete(::operator new(bytes));
    const int one = 1;
    double matrix = 1.0;
    int pivot = 0, info = 0;
    dgetrf_(&one, &one, &matrix, &one, &pivot, &info);
    return true;
  }();
  static_cast<void>(reserved);
}

}  // namespace talus::linear
