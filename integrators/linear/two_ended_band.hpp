#pragma once

#include <span>
#include <vector>

#include "linear/band_lu.hpp"
#include "linear/direct_solver.hpp"
#include "linear/packed_factors.hpp"

namespace talus::linear {

/// LU of a band matrix from both ends at once, on two threads: the unknowns are cut into a left part, a separator as wide as the
/// band, and a right part that is numbered from its far end. Each part is factored with row exchanges, at most `window` rows
/// away; a dense matrix joins them on the separator. Small matrices have an empty right part and separator and use one
/// thread. Entries and factors are kept in `Real`, float or double.
/// The arithmetic does not depend on how the threads run: same input, same bits.
template <class Real>
class TwoEndedBand {
 public:
  TwoEndedBand() = default;
  /// A band of n rows with `width` diagonals on either side of the main one. A window as wide as the band finds a pivot wherever
  /// there is one.
  TwoEndedBand(Index n, Index width, Index window);

  [[nodiscard]] Index n() const { return n_; }
  [[nodiscard]] Index width() const { return width_; }
  /// Makes room for the entries, and sets all to zero.
  void clear();
  /// Says that A(i, j) may differ from zero, |i - j| <= width: substitution passes over the ends of rows and columns where
  /// nothing was announced.
  void expect(Index i, Index j);
  /// Where A(i, j) is kept, for add(slot, value).
  [[nodiscard]] Index slot(Index i, Index j) const;
  /// A(i, j) += value. The entry was announced.
  void add(Index slot, double value) { store_[slot] += static_cast<Real>(value); }
  /// A(i, j) += scale * v[i - first], for i in [first, first + v.size()).
  void add_column(Index j, Index first, Real scale, std::span<const Real> v);
  /// Throws SingularMatrix.
  void factor();
  /// b <- A^-1 b.
  void solve(std::span<Real> b) const;
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Part {
    Index n = 0;     ///< unknowns
    Index tail = 0;  ///< how many of the last ones the separator's columns reach once they are eliminated
    Index band = 0;  ///< where it starts in the store
    Index to = 0;    ///< rows of the tail x separator columns: F, shape (tail, m), column major
    Index from = 0;  ///< separator rows x columns of the tail: G, shape (m, tail), column major
    BandLu<Real> lu;
    PackedFactors<Real> factors;  ///< for substitution
  };
  /// 0 left, 1 right, 2 separator, and the number there.
  struct Place {
    int part;
    Index number;
  };
  [[nodiscard]] Place place(Index i) const {
    if (i < left_) return {0, i};
    if (i < left_ + separator_) return {2, i - left_};
    return {1, n_ - 1 - i};
  }
  void factor_part(Part& part, std::vector<Real>& schur);

  Index n_ = 0, width_ = 0, left_ = 0, separator_ = 0, size_ = 0, middle_ = 0;
  Part part_[2];
  std::vector<Real> store_;   ///< bands, borders and, from middle_ on, the separator's own block, shape (m, m)
  std::vector<Real> joined_;  ///< its Schur complement in factors
  std::vector<int> joined_pivots_;
};

}  // namespace talus::linear
