#pragma once

#include <vector>

#include "rheology/law.hpp"

namespace talus::rheology {

enum class Branch { rational, creep };

/// An I at which a branch of a law passes a bound of well-posedness.
struct BranchPoint {
  double I;
  Branch branch;
  bool relevant;  ///< the law uses this branch at this I; the other branch rules there otherwise
};

/// All I > 0 at which C (3.18) of a branch changes sign, ascending, exact to rounding: roots of polynomials
/// (README.md), so none is missed however close to another or far out. The parabola below `tiny_I` has none.
[[nodiscard]] std::vector<BranchPoint> branch_neutral_points(const Law& law);
/// Likewise |q| = 1, where the pressure equation stops being elliptic.
[[nodiscard]] std::vector<BranchPoint> branch_ellipticity_bounds(const Law& law);

/// All I at which C of the law itself changes sign, ascending; a jump across zero at I_N counts.
[[nodiscard]] std::vector<double> neutral_points(const Law& law);
/// Likewise |q| - 1.
[[nodiscard]] std::vector<double> ellipticity_bounds(const Law& law);

/// I from `from` to `to`, which may be infinite.
struct Range {
  double from, to;
};
/// Where C <= 0: well-posed by (3.18), for nu > 1/2 with room to spare.
[[nodiscard]] std::vector<Range> ranges_of_condition(const Law& law);
/// Where no short wave grows: well-posed by the linear theory.
[[nodiscard]] std::vector<Range> ranges_of_damping(const Law& law);

}  // namespace talus::rheology
