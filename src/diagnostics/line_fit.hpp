#pragma once

#include <span>

namespace talus::diagnostics {

/// The least-squares line y = y_mean + slope (x - x_mean) and the root mean square of what it leaves.
struct LineFit {
  double slope, x_mean, y_mean, rms;
};

/// Throws std::invalid_argument for fewer than two points, different shapes, or all x alike.
[[nodiscard]] LineFit fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace talus::diagnostics
