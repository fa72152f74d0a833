#include "linear/blas.hpp"

extern "C" {
// Of OpenBLAS; null with any other BLAS.
int openblas_get_parallel() __attribute__((weak));
void openblas_set_num_threads(int n) __attribute__((weak));
}

namespace talus::linear {

bool blas_allows_threads() {
  constexpr int sequential = 0;
  return openblas_get_parallel == nullptr || openblas_get_parallel() != sequential;
}

void limit_blas_to_one_thread() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

}  // namespace talus::linear
