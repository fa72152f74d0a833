#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "linear/blas.hpp"

extern "C" {
void sgemm_(const char* trans_a, const char* trans_b, const int* m, const int* n, const int* k, const float* alpha,
            const float* a, const int* lda, const float* b, const int* ldb, const float* beta, float* c,
            const int* ldc);
void strsm_(const char* side, const char* uplo, const char* trans_a, const char* diag, const int* m, const int* n,
            const float* alpha, const float* a, const int* lda, float* b, const int* ldb);
}

/// What goes through BLAS as a vector, since it is one column, is what that column is among two.
namespace {

using namespace talus;

constexpr int leading = 9, size = leading * leading;

std::vector<float> some(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-1.0F, 1.0F);
  std::vector<float> list(size);
  for (float& x : list) x = number(random);
  return list;
}

TEST(SingleColumn, OfAProductIsThatOfTwo) {
  linear::reserve_blas_work_space();
  const auto a = some(1), b = some(2), c = some(3);
  for (const char* trans_a : {"N", "T", "n", "t"})
    for (const char* trans_b : {"N", "T"})
      for (const float beta : {0.0F, 1.0F, -0.3F}) {
        const int m = 7, k = 5, one = 1, two = 2;
        const float alpha = 0.7F;
        auto alone = c, among = c;
        sgemm_(trans_a, trans_b, &m, &two, &k, &alpha, a.data(), &leading, b.data(), &leading, &beta, among.data(),
               &leading);
        sgemm_(trans_a, trans_b, &m, &one, &k, &alpha, a.data(), &leading, b.data(), &leading, &beta, alone.data(),
               &leading);
        for (int i = 0; i < size; ++i)
          EXPECT_NEAR(alone[i], i < m ? among[i] : c[i], 1e-6) << trans_a << trans_b << beta << ' ' << i;
      }
}

TEST(SingleColumn, OfAProductForgetsWhatWasThereWhereItIsTold) {
  linear::reserve_blas_work_space();
  const auto a = some(1), b = some(2);
  std::vector<float> c(size, std::numeric_limits<float>::quiet_NaN());
  const int m = 7, k = 5, one = 1;
  const float alpha = 1.0F, beta = 0.0F;
  sgemm_("N", "N", &m, &one, &k, &alpha, a.data(), &leading, b.data(), &leading, &beta, c.data(), &leading);
  for (int i = 0; i < m; ++i) EXPECT_TRUE(std::isfinite(c[i])) << i;
}

TEST(SingleColumn, OfASubstitutionIsThatOfTwo) {
  linear::reserve_blas_work_space();
  auto a = some(4);
  const auto b = some(5);
  for (int i = 0; i < leading; ++i) a[i * (leading + 1)] += 3.0F;
  const int m = 7, one = 1, two = 2;
  for (const char* uplo : {"U", "L"})
    for (const char* trans : {"N", "T"})
      for (const char* diag : {"N", "U"})
        for (const float alpha : {1.0F, 0.5F}) {
          auto alone = b, among = b;
          strsm_("L", uplo, trans, diag, &m, &two, &alpha, a.data(), &leading, among.data(), &leading);
          strsm_("L", uplo, trans, diag, &m, &one, &alpha, a.data(), &leading, alone.data(), &leading);
          for (int i = 0; i < size; ++i)
            EXPECT_NEAR(alone[i], i < m ? among[i] : b[i], 1e-4 * (1.0 + std::abs(among[i])))
                << uplo << trans << diag << ' ' << i;
        }
  auto right = b;
  const float unity = 1.0F;
  strsm_("R", "U", "N", "N", &m, &one, &unity, a.data(), &leading, right.data(), &leading);
  for (int i = 0; i < m; ++i) EXPECT_NEAR(right[i], b[i] / a[0], 1e-6);
}

}  // namespace
