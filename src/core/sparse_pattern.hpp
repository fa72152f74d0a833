#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace talus::core {

using Index = std::int64_t;

/// Frozen compressed-sparse-column pattern of a square matrix; rows are ascending within a column.
class SparsePattern {
 public:
  SparsePattern() = default;
  /// From (row, column) pairs in any order, duplicates allowed. Throws std::out_of_range for an index outside [0, n).
  SparsePattern(Index n, std::vector<std::pair<Index, Index>> entries);

  [[nodiscard]] Index n() const { return n_; }
  [[nodiscard]] Index n_nonzeros() const { return static_cast<Index>(row_of_.size()); }
  /// n + 1 offsets into rows().
  [[nodiscard]] std::span<const Index> column_starts() const { return column_start_; }
  [[nodiscard]] std::span<const Index> rows() const { return row_of_; }
  /// Position of (row, column) in the value array, or -1 where the pattern has no such entry.
  [[nodiscard]] Index find(Index row, Index column) const;

 private:
  Index n_ = 0;
  std::vector<Index> column_start_;
  std::vector<Index> row_of_;
};

}  // namespace talus::core
