#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace talus::sweep {

enum class Spacing : std::uint8_t { linear, logarithmic };

/// From one number to another, both finite; above 0 where the spacing is logarithmic.
struct Interval {
  double from;
  double to;
  Spacing spacing = Spacing::linear;
  /// The number at a share [1] of the way, share in [0, 1], rounded to twelve digits; exactly `from` and `to` at its ends.
  /// Made of sums, products, quotients and square roots, which IEEE 754 rounds alike: the same bits on every machine.
  [[nodiscard]] double at(double share) const;
};

/// `count` >= 2 numbers, the ends among them.
std::vector<double> spaced(const Interval& interval, std::size_t count);

}  // namespace talus::sweep
