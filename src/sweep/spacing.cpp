#include "sweep/spacing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace talus::sweep {
namespace {

/// base^share, share in [0, 1): the product of the roots of `base` that the binary digits of the share name.
double power(double base, double share) {
  double result = 1.0;
  for (double root = base; share > 0.0 && root != 1.0;) {
    root = std::sqrt(root);
    share *= 2.0;
    if (share >= 1.0) {
      result *= root;
      share -= 1.0;
    }
  }
  return result;
}

/// Twelve significant digits: 0.3, not 0.30000000000000004.
double rounded(double x) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific, 11).ptr;
  std::from_chars(text.data(), end, x);
  return x;
}

}  // namespace

double Interval::at(double share) const {
  if (share <= 0.0) return from;
  if (share >= 1.0) return to;
  const double x = spacing == Spacing::linear ? from + share * (to - from) : from * power(to / from, share);
  return std::clamp(rounded(x), std::min(from, to), std::max(from, to));
}

std::vector<double> spaced(const Interval& interval, std::size_t count) {
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = interval.at(static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return numbers;
}

}  // namespace talus::sweep
