#include "linear/blas.hpp"

#include <cstddef>
#include <new>

extern "C" {
// Of OpenBLAS; null with any other BLAS.
int openblas_get_parallel() __attribute__((weak));
void openblas_set_num_threads(int n) __attribute__((weak));

void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
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
