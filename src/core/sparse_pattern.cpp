#include "core/sparse_pattern.hpp"

#include <algorithm>
#include <stdexcept>

namespace talus::core {

SparsePattern::SparsePattern(Index n, std::vector<std::pair<Index, Index>> entries) : n_(n), column_start_(n + 1, 0) {
  for (const auto& [row, column] : entries)
    if (row < 0 || row >= n || column < 0 || column >= n)
      throw std::out_of_range("SparsePattern: entry outside the matrix");
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first < b.first;
  });
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  row_of_.reserve(entries.size());
  for (const auto& [row, column] : entries) {
    row_of_.push_back(row);
    ++column_start_[column + 1];
  }
  for (Index j = 0; j < n; ++j) column_start_[j + 1] += column_start_[j];
}

Index SparsePattern::find(Index row, Index column) const {
  const auto first = row_of_.begin() + column_start_[column];
  const auto last = row_of_.begin() + column_start_[column + 1];
  const auto it = std::lower_bound(first, last, row);
  return it != last && *it == row ? it - row_of_.begin() : -1;
}

}  // namespace talus::core
