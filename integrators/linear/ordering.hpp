#pragma once

#include <span>
#include <vector>

#include "core/sparse_pattern.hpp"

namespace talus::linear {

/// An ordering lists the unknowns by their new place.
using Ordering = std::vector<core::Index>;

[[nodiscard]] Ordering natural_ordering(core::Index n);
/// Place of each unknown. Throws std::invalid_argument where the ordering is no permutation.
[[nodiscard]] Ordering inverse(std::span<const core::Index> ordering);
/// Cuthill and McKee's breadth-first numbering of the graph of A + A^T, reversed, each component from an end of its
/// longest level structure (Gibbs, Poole and Stockmeyer's start).
[[nodiscard]] Ordering reverse_cuthill_mckee(const core::SparsePattern& pattern);

/// Nested dissection of the graph of A + A^T by METIS. Throws std::bad_alloc.
[[nodiscard]] Ordering nested_dissection(const core::SparsePattern& pattern);

struct Bandwidth {
  core::Index lower, upper;
  /// In proportion to the operations of a band factorisation with pivoting.
  [[nodiscard]] double work() const { return static_cast<double>(lower) * static_cast<double>(lower + upper + 1); }
};
[[nodiscard]] Bandwidth bandwidth(const core::SparsePattern& pattern, std::span<const core::Index> ordering);

}  // namespace talus::linear
