#pragma once

#include <cstdint>
#include <vector>

#include "linear/band_lu.hpp"

namespace talus::linear {

/// L and U of a band copied close together, four columns at a time, for substitution: what bounds a solve is the memory that it
/// reads, and a band keeps room beside what counts.
template <class Real>
class PackedFactors {
 public:
  /// Copies the last factors of `lu`, which `store` holds. `tail`: as the band's, how many rows before the end substitution may
  /// start.
  void pack(const BandLu<Real>& lu, const Real* store, Index tail);
  /// b <- L^-1 P b on rows from `first` on, the tail's or 0; b points at row `first`.
  void forward(Index first, Real* b) const;
  /// b <- U^-1 b on rows from `first` on, whose solution does not depend on the rows before.
  void backward(Index first, Real* b) const;
  [[nodiscard]] std::size_t memory() const { return values_.size() * sizeof(Real); }

 private:
  struct Kernels;
  static constexpr Index width = 4;
  /// Columns [first, first + count): a dense square each for L and U, then the columns of what lies below and above it.
  struct Group {
    Index first;
    int count;
    int below, above;           ///< rows outside the square
    std::int64_t lower, upper;  ///< where in values_ they start
    std::size_t exchanges;      ///< how many there are before the next group
  };
  [[nodiscard]] std::size_t group_from(Index first) const { return first == 0 ? 0 : tail_group_; }

  std::vector<Group> groups_;
  std::size_t tail_group_ = 0;
  std::vector<typename BandLu<Real>::Exchange> exchanges_;
  std::vector<Real> values_;  ///< of L, then of U
};

}  // namespace talus::linear
