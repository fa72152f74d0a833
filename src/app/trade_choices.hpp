#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "config/key.hpp"
#include "sweep/design.hpp"

namespace talus::app {

/// One way to compute a scene: what of it differs from the scene as it stands.
struct TradeChoice {
  std::string group;  ///< what is varied: "grid", "rtol", ...; "scene" and "reference" stand for themselves
  std::string words;  ///< "60x16", "1e-3"
  std::map<std::string, config::Scalar> settings;  ///< by scene key
  /// A power of two by which the cells differ from the scene's in each direction, where nothing else does; else 0.
  double cells_ratio = 0.0;
};

/// All choices of a study; the first is the scene as it stands, the second the reference.
struct TradeChoices {
  std::vector<TradeChoice> all;
  std::vector<std::string> left_out;  ///< choices that the scene refuses, with the reason
};

/// Cells of the reference and its tolerances against the scene's.
inline constexpr int reference_refinement = 2;
inline constexpr int reference_tolerances = 10;

/// What there is to choose for the scene's model: grids, tolerances, order, cap, smoothing of the pressure, speed of wall friction,
/// advection, spacing of layers, linear solver, Newton's method, rung. Only where a scene file could say so, too.
TradeChoices trade_choices(const Scene& scene);

/// The choices as a dimension "choice" of a sweep: all keys that any of them sets move together.
sweep::Dimension dimension_of(const TradeChoices& choices, const Scene& scene);

}  // namespace talus::app
