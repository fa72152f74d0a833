#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace talus::study {

/// What the values of one number on grids refined by a constant ratio say of its limit, by the three finest of them.
enum class Tendency : std::uint8_t {
  settled,  ///< the last two differences are below what the integrator resolves: no order can be seen, none is needed
  convergent,   ///< differences of one sign that fall at an order of at least `least_order`
  slow,         ///< that fall, but more slowly
  oscillating,  ///< that fall and change their sign: a limit, but no order
  divergent,    ///< that do not fall
  unknown       ///< fewer than three levels, or a value is missing
};
/// "settled" and so on.
[[nodiscard]] std::string_view word_of(Tendency tendency);
/// All of them, in the order of the enumeration.
[[nodiscard]] const std::vector<Tendency>& tendencies();

inline constexpr double least_order = 0.5;
/// Second order is what the schemes are made for: a faster fall is shown as it is, but not built upon.
inline constexpr double highest_order = 2.0;

/// Of one number; NaN stands for what cannot be said.
struct Convergence {
  Tendency tendency = Tendency::unknown;
  std::vector<double>
      orders;          ///< observed, of each three neighbouring levels from the coarsest on: shape n - 2, or empty
  double value;        ///< the best estimate: Richardson's where convergent or slow, else the finest level's
  double uncertainty;  ///< half width of where the limit is expected about the value on the finest level (GCI)
  double error;        ///< |finest level's value - value|
};

/// `values`: from the coarsest to the finest level, cells smaller by `ratio` (> 1) each time. `resolution`: differences
/// below it are the integrator's own, in the unit of the values.
///
/// With e_i the difference of level i from the one before: order p = ln(e_(n-2)/e_(n-1))/ln(ratio), extrapolated value
/// f_n + e_(n-1)/(ratio^p' - 1) with p' = min(p, 2), grid convergence index F |e_(n-1)|/(ratio^p' - 1) after Roache. F = 1.25
/// where two neighbouring triples of levels show orders within 0.3 of each other, both at least `least_order`, else 3.
/// Oscillating: three times the larger of the last two differences. Settled: the larger of them. Divergent: none.
/// Throws std::invalid_argument for a ratio not above 1.
[[nodiscard]] Convergence convergence(std::span<const double> values, double ratio, double resolution);

/// Of a field known by the norms of its differences between neighbouring levels, of which only the size can be seen:
/// norms[i] of level i + 1 against level i. Orders of each two neighbouring norms; `value` is NaN, `error` and `uncertainty`
/// estimate the same norm of the finest level's error.
[[nodiscard]] Convergence convergence_of_differences(std::span<const double> norms, double ratio, double resolution);

}  // namespace talus::study
