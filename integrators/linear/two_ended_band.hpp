#pragma once

#include <span>
#include <vector>

#include "linear/direct_solver.hpp"

namespace talus::linear {

/// LU of a band matrix from both ends at once, on two threads where BLAS allows it (blas.hpp): the unknowns are cut into a left part, a separator as wide as
/// the band, and a right part that is numbered from its far end. LAPACK factors the parts with partial pivoting; a dense
/// matrix joins them on the separator. Small matrices have an empty right part and separator and use one thread.
/// The arithmetic does not depend on how the threads run: same input, same bits.
class TwoEndedBand {
 public:
  TwoEndedBand() = default;
  /// A band of n rows with `width` diagonals on either side of the main one.
  TwoEndedBand(Index n, Index width);

  [[nodiscard]] Index n() const { return n_; }
  [[nodiscard]] Index width() const { return width_; }
  /// Sets all entries to zero.
  void clear();
  /// A(i, j) += value, |i - j| <= width.
  void add(Index i, Index j, double value);
  /// A(i, j) += scale * v[i - first], for i in [first, first + v.size()).
  void add_column(Index j, Index first, double scale, std::span<const double> v);
  /// Throws SingularMatrix.
  void factor();
  /// b <- A^-1 b.
  void solve(std::span<double> b) const;
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Part {
    Index n = 0;               ///< unknowns
    std::vector<double> band;  ///< LAPACK band storage, leading dimension 3 width + 1
    std::vector<int> pivots;
    std::vector<int> above,
        below;               ///< entries of U above and of L below the diagonal of each column, up to the last non-zero
    std::vector<double> to;  ///< part rows of the window x separator columns: F, shape (window, m), column major
    std::vector<double> from;  ///< separator rows x part columns of the window: G, shape (m, window), column major
  };
  [[nodiscard]] Index leading() const { return 3 * width_ + 1; }
  [[nodiscard]] Index window(const Part& part) const { return part.n < 2 * width_ ? part.n : 2 * width_; }
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
  /// Measures how far the factors reach: substitution then passes over the zeros at the ends of columns.
  void measure(Part& part) const;
  void factor_part(Part& part, std::vector<double>& schur) const;
  void forward(const Part& part, Index first, double* b) const;
  void backward(const Part& part, Index first, double* b) const;

  Index n_ = 0, width_ = 0, left_ = 0, separator_ = 0;
  Part part_[2];
  std::vector<double> middle_,
      joined_;  ///< the separator's own block, and its Schur complement in factors, shape (m, m)
  std::vector<int> joined_pivots_;
};

}  // namespace talus::linear
