#pragma once

#include <span>
#include <vector>

#include "linear/direct_solver.hpp"

namespace talus::linear {

/// LU of a square band by panels of columns, with row exchanges over a short way. It calls no library, so that two threads may
/// factor two matrices at once, and uses AVX2 and FMA where the processor has them.
///
/// A row is exchanged where one of at most `window` rows below has an entry in its column that is more than twice as large.
/// L is kept as it stands after all exchanges of its panel.
template <class Real>
class BandLu {
 public:
  static constexpr Index panel = 32;  ///< columns that are eliminated together
  /// An entry below a pivot may be so many times larger where no exchange could reach it.
  static constexpr double most_growth = 1e3;

  BandLu() = default;
  /// n rows with `width` diagonals on either side. A panel begins at row n - `tail`, at which solve_tail() may start.
  BandLu(Index n, Index width, Index window, Index tail);

  [[nodiscard]] Index n() const { return n_; }
  /// How many numbers of storage the band takes, and how many lie between A(i, j) and A(i, j + 1).
  [[nodiscard]] Index storage() const { return n_ * leading_; }
  [[nodiscard]] Index stride() const { return leading_ - 1; }
  /// Where A(i, j) is kept.
  [[nodiscard]] Index slot(Index i, Index j) const { return j * leading_ + above_ + i - j; }
  /// Says that A(i, j) may differ from zero.
  void expect(Index i, Index j);
  /// Factors what `store`, shape storage(), holds; the factors take its place. Throws SingularMatrix where a pivot vanishes, or
  /// is a thousandth of an entry below it that was out of reach.
  void factor(Real* store);
  /// X <- U^-1 L^-1 P X for rows from n - tail on, shape (tail, m), column major, as if nothing came before them.
  void solve_tail(const Real* store, Index m, Real* X) const;

  /// C -= A B, of shapes (m, n), (m, k), (k, n), column major without gaps.
  static void subtract_product(Index m, Index n, Index k, const Real* A, const Real* B, Real* C);

  /// What substitution needs to know of the last factors.
  struct Exchange {
    int row, with;
  };
  [[nodiscard]] const std::vector<Index>& panels() const { return panels_; }  ///< first columns, and n
  [[nodiscard]] std::span<const Exchange> exchanges(std::size_t number) const {
    return {exchanges_.data() + first_exchange_[number], exchanges_.data() + first_exchange_[number + 1]};
  }
  [[nodiscard]] int last_row_of_L(Index column) const { return L_end_[column]; }     ///< never falls
  [[nodiscard]] int first_row_of_U(Index column) const { return U_start_[column]; }  ///< never falls

 private:
  struct Kernels;
  void lengthen(Index a, Index b);
  Index n_ = 0, width_ = 0, window_ = 0, tail_ = 0, above_ = 0, leading_ = 0;
  std::vector<Index> panels_;
  std::vector<int> last_row_, last_column_;  // of columns and rows, as announced
  std::vector<int> L_end_, U_start_;
  std::vector<std::size_t> first_exchange_;
  std::vector<Exchange> exchanges_;
};

}  // namespace talus::linear
