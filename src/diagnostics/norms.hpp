#pragma once

#include <span>

namespace talus::diagnostics {

/// Norms of a field, in its own unit: L1 = sum w|e|/sum w, L2 = sqrt(sum w e^2/sum w), Linf = max |e|. A NaN makes all
/// three NaN.
struct Norms {
  double l1, l2, linf;
};

/// Every entry weighs the same. Throws std::invalid_argument where there is none.
[[nodiscard]] Norms norms(std::span<const double> e);
/// With weights >= 0, say cell areas; entries of weight zero do not count, not even in Linf. Throws
/// std::invalid_argument where the shapes differ, a weight is negative or their sum is zero.
[[nodiscard]] Norms norms(std::span<const double> e, std::span<const double> weight);

/// L2 of value - reference over L2 of reference, same weights [1].
[[nodiscard]] double relative_l2(std::span<const double> value, std::span<const double> reference,
                                 std::span<const double> weight);

}  // namespace talus::diagnostics
