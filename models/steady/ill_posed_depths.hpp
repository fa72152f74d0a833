#pragma once

#include <optional>
#include <vector>

#include "rheology/neutral_points.hpp"
#include "rheology/well_posedness.hpp"
#include "steady/uniform_flow.hpp"

namespace talus::steady {

/// A range of depths [m] below the surface.
struct DepthRange {
  double from, to;
};

/// Where a law is ill-posed, as inertial numbers: what every flow of that law is held against.
struct PosednessBounds {
  std::vector<double> neutral;   ///< C (3.18) changes its sign; ascending
  std::vector<double> q_is_one;  ///< the bound of the linear theory at high inertial numbers; ascending
};
[[nodiscard]] PosednessBounds posedness_bounds(const rheology::Law& law);

/// Where a flow is ill-posed. The inertial number falls from the surface down, through the high ill-posed range first and,
/// with the classical law, into the low one.
struct IllPosedDepths {
  double C_surface, q_surface;
  std::vector<DepthRange> C_positive;  ///< from the surface down
  std::vector<DepthRange> q_beyond;    ///< q >= 1
  /// How far the surface stays below the highest neutral point, and below q = 1, in I; negative beyond it. None where the
  /// law has no such point.
  std::optional<double> C_margin, q_margin;
};
[[nodiscard]] IllPosedDepths ill_posed_depths(const UniformFlow& flow, const PosednessBounds& bounds);

}  // namespace talus::steady
