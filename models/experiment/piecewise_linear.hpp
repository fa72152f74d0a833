#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace talus::experiment {

/// A quantity given at some points of time or space: linear between them, constant outside. Empty: not given.
struct PiecewiseLinear {
  std::vector<double> at;      ///< strictly ascending
  std::vector<double> values;  ///< as many
};

/// Whether it keeps what its members promise.
inline bool is_sound(const PiecewiseLinear& f) {
  return f.at.size() == f.values.size() && std::ranges::adjacent_find(f.at, std::greater_equal{}) == f.at.end();
}

/// The value at x; `otherwise` where nothing is given.
inline double value_at(const PiecewiseLinear& f, double x, double otherwise) {
  if (f.at.empty()) return otherwise;
  const auto after = std::ranges::upper_bound(f.at, x);
  if (after == f.at.begin()) return f.values.front();
  if (after == f.at.end()) return f.values.back();
  const auto i = static_cast<std::size_t>(after - f.at.begin());
  const double share = (x - f.at[i - 1]) / (f.at[i] - f.at[i - 1]);
  return (1.0 - share) * f.values[i - 1] + share * f.values[i];
}

}  // namespace talus::experiment
