#pragma once

#include <cstdint>
#include <vector>

#include "linear/direct_solver.hpp"

namespace talus::linear {

/// L and U of a band as LAPACK's gbtrf leaves them, copied close together and four columns at a time, for substitution: what
/// bounds a solve is the memory that it reads, and a band keeps two numbers beside each that counts.
template <class Real>
class PackedFactors {
 public:
  /// What is copied: factors in LAPACK's band storage.
  struct Band {
    Index n;              ///< rows
    const Real* diagonal;  ///< of column 0, in the band
    Index leading;        ///< numbers a column
    Index below, above;   ///< numbers kept a column below and above the diagonal
    const int* pivots;    ///< from 1 on, shape n
    const int* L_reach;   ///< entries of L below the diagonal of each column, whose last row never falls, shape n
    const int* U_reach;   ///< entries of U above it, whose first row never falls, shape n
  };

  /// `window`: a multiple of columns from the end at which substitution may start, beside the whole.
  void pack(const Band& band, Index window);
  /// b <- L^-1 P b on rows from `first` on, the window's or 0; b points at row `first`.
  void forward(Index first, Real* b) const;
  /// b <- U^-1 b on rows from `first` on, whose solution does not depend on the rows before.
  void backward(Index first, Real* b) const;
  [[nodiscard]] std::size_t memory() const { return values_.size() * sizeof(Real); }

 private:
  static constexpr Index width = 4;
  /// Columns [first, first + count): a dense triangle each of L and U, then count columns of what lies below and above it.
  struct Group {
    Index first;
    int count;
    bool exchanges;      ///< some pivot is not its own row
    int below, above;    ///< rows of the columns outside the triangle
    std::int64_t lower;  ///< where count x count numbers of L start, then the columns below; and where U's
    std::int64_t upper;
  };
  [[nodiscard]] std::size_t group_from(Index first) const { return first == 0 ? 0 : window_group_; }

  std::vector<Group> groups_;
  std::size_t window_group_ = 0;
  std::vector<int> pivots_;
  std::vector<Real> values_;  ///< lowers in order, then uppers
};

}  // namespace talus::linear
