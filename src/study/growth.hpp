#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace talus::study {

/// An exponential fitted to a disturbance: amplitude ~ e^(rate t).
struct GrowthFit {
  double rate;  ///< [1/s]; NaN where fewer than four points have an amplitude
  double
      uncertainty;  ///< half the difference of the rates of the two halves of the window, or the line's standard error if larger
  double from, to;  ///< the window [s]
  std::size_t n;    ///< points in it
};

/// Least squares of the amplitudes' logarithms within [from, to]; amplitudes that are not above 0 are left out. Shapes alike, times
/// ascending. Throws std::invalid_argument otherwise.
[[nodiscard]] GrowthFit fit_growth(std::span<const double> times, std::span<const double> amplitudes, double from,
                                   double to);

/// What growth rates on refined grids say.
enum class GrowthTendency : std::uint8_t {
  decays,  ///< on every grid, within the uncertainties
  converges,  ///< the rates of the two finest grids agree within their uncertainties, or the last two differences fall at an order of
  ///< at least least_order
  blows_up,  ///< positive on the three finest grids and rising from each to the next, with the grid's wave number, as k^n, n at least 1/2
  not_convergent,  ///< positive on the three finest grids, with differences that do not fall, but no power of at least 1/2
  cannot_tell      ///< none of these: finer grids may
};
[[nodiscard]] std::string_view word_of(GrowthTendency tendency);
/// All of them, in the order of the enumeration.
[[nodiscard]] const std::vector<GrowthTendency>& growth_tendencies();

struct GrowthVerdict {
  GrowthTendency tendency;
  double exponent;  ///< n of rate ~ k^n over the three finest grids; NaN where they are not all positive
  int finer = 0;    ///< where it cannot tell: refinements beyond the finest grid after which it may
};

/// `rates`: from the coarsest grid on, each with cells smaller by `ratio`. Fewer than three cannot tell.
[[nodiscard]] GrowthVerdict growth_verdict(std::span<const GrowthFit> rates, double ratio);

}  // namespace talus::study
