#include "linear/band_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "linear/packed_factors.hpp"

/// The band's LU against a dense one.
namespace {
using namespace talus;
using linear::Index;

template <class Real>
using Dense = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// A band whose diagonal is `weight` times as large as what stands beside it.
Eigen::MatrixXd random_band(Index n, Index width, double weight) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = std::max<Index>(0, j - width); i <= std::min(n - 1, j + width); ++i)
      A(i, j) = number(random) * (i == j ? weight : 1.0);
  return A;
}

template <class Real>
struct Factored {
  linear::BandLu<Real> lu;
  linear::PackedFactors<Real> packed;
  std::vector<Real> store;

  Factored(const Eigen::MatrixXd& A, Index width, Index window, Index tail) : lu(A.rows(), width, window, tail) {
    store.assign(lu.storage(), Real(0));
    for (Index j = 0; j < A.cols(); ++j)
      for (Index i = 0; i < A.rows(); ++i) {
        if (A(i, j) == 0.0) continue;
        lu.expect(i, j);
        store[lu.slot(i, j)] = static_cast<Real>(A(i, j));
      }
    lu.factor(store.data());
    packed.pack(lu, store.data(), tail);
  }
  [[nodiscard]] double error(const Eigen::MatrixXd& A) const {
    Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(A.rows(), -1.0, 2.0);
    const Eigen::VectorXd right = A * expected;
    std::vector<Real> b(right.data(), right.data() + right.size());
    packed.forward(0, b.data());
    packed.backward(0, b.data());
    double most = 0.0;
    for (Index i = 0; i < A.rows(); ++i) most = std::max(most, std::abs(static_cast<double>(b[i]) - expected(i)));
    return most;
  }
};

TEST(BandLu, SolvesBandsOfManySizes) {
  for (const Index n : {1, 5, 31, 32, 33, 70, 200})
    for (const Index width : {0, 1, 7, 40}) {
      const Index w = std::min(width, n - 1);
      const auto A = random_band(n, w, 4.0 + 2.0 * static_cast<double>(w));
      EXPECT_LT((Factored<double>(A, w, w, std::min<Index>(n, 20)).error(A)), 1e-12) << n << " " << w;
      EXPECT_LT((Factored<float>(A, w, 4, std::min<Index>(n, 20)).error(A)), 1e-3) << n << " " << w;
    }
}

TEST(BandLu, ExchangesRowsWhereADiagonalVanishes) {
  auto A = random_band(150, 12, 1.0);
  for (Index i = 0; i < 150; i += 3) A(i, i) = 0.0;
  const Factored<double> factored(A, 12, 12, 30);
  std::size_t exchanges = 0;
  for (std::size_t p = 0; p + 1 < factored.lu.panels().size(); ++p) exchanges += factored.lu.exchanges(p).size();
  EXPECT_GT(exchanges, 5u);
  const double condition = A.norm() * A.inverse().norm();
  EXPECT_LT(factored.error(A), 1e-15 * condition * 150);
}

TEST(BandLu, FactorsAreTheMatrix) {
  const auto A = random_band(90, 9, 1.0);
  const Factored<double> factored(A, 9, 9, 90);
  // L^-1 P A e_j = U e_j: zero below the diagonal.
  for (Index j = 0; j < 90; ++j) {
    const Eigen::VectorXd a = A.col(j);
    std::vector<double> column(a.data(), a.data() + 90);
    factored.packed.forward(0, column.data());
    for (Index i = j + 1; i < 90; ++i) EXPECT_NEAR(column[i], 0.0, 1e-11) << i << " " << j;
    for (Index i = 0; i < factored.lu.first_row_of_U(j); ++i) EXPECT_NEAR(column[i], 0.0, 1e-11) << i << " " << j;
  }
}

TEST(BandLu, ItsTailIsTheSchurComplement) {
  constexpr Index n = 120, tail = 50;
  const auto A = random_band(n, 8, 1.0);
  const Factored<double> factored(A, 8, 8, tail);
  const Index head = n - tail;
  const Eigen::MatrixXd schur = A.bottomRightCorner(tail, tail) - A.bottomLeftCorner(tail, head) *
                                                                      A.topLeftCorner(head, head).inverse() *
                                                                      A.topRightCorner(head, tail);
  // Rows exchanged across the cut make another complement of the same whole; the inverse's corner is what both share.
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(n, 3);
  X.bottomRows(tail).setRandom();
  const Eigen::MatrixXd expected = A.lu().solve(X).bottomRows(tail);
  Eigen::MatrixXd b = schur.lu().solve(X.bottomRows(tail));
  EXPECT_LT((b - expected).norm(), 1e-9 * expected.norm());
  std::vector<double> whole(X.data(), X.data() + n);
  factored.packed.forward(0, whole.data());
  std::vector<double> part(whole.begin() + head, whole.end());
  factored.packed.backward(head, part.data());
  for (Index i = 0; i < tail; ++i) EXPECT_NEAR(part[i], expected(i, 0), 1e-9);
}

TEST(BandLu, ManyRightSidesAtOnceAreAsEachAlone) {
  constexpr Index n = 100, tail = 70, m = 9;
  const auto A = random_band(n, 10, 1.0);
  const Factored<double> factored(A, 10, 10, tail);
  Eigen::MatrixXd X = Eigen::MatrixXd::Random(tail, m), expected = X;
  factored.lu.solve_tail(factored.store.data(), m, X.data());
  for (Index c = 0; c < m; ++c) {
    factored.packed.forward(n - tail, expected.col(c).data());
    factored.packed.backward(n - tail, expected.col(c).data());
  }
  EXPECT_LT((X - expected).norm(), 1e-10 * expected.norm());
}

TEST(BandLu, SaysWhereNoPivotIsWithinReach) {
  auto A = random_band(60, 20, 1.0);
  EXPECT_NO_THROW((Factored<double>(A, 20, 20, 10)));
  for (Index i = 20; i <= 24; ++i) A(i, 20) = 1e-9;
  for (Index i = 0; i < 20; ++i) A(i, 20) = 0.0;
  A.row(20).head(20).setZero();
  A.block(21, 0, 4, 20).setZero();
  EXPECT_THROW((Factored<double>(A, 20, 3, 10)), linear::SingularMatrix);
  EXPECT_NO_THROW((Factored<double>(A, 20, 20, 10)));
}

TEST(BandLu, RefusesASingularMatrix) {
  auto A = random_band(40, 5, 1.0);
  A.col(17).setZero();
  EXPECT_THROW((Factored<double>(A, 5, 5, 10)), linear::SingularMatrix);
}

}  // namespace
