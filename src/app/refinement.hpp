#pragma once

#include <optional>
#include <string>

#include "app/scene.hpp"
#include "sweep/design.hpp"

namespace talus::app {

/// What of a scene a study refines: columns along x, layers along z, tolerances in t.
struct Refinement {
  bool x, z, t;
  /// "x, z": for people.
  [[nodiscard]] std::string words() const;
};

/// Cells shrink by this from level to level.
inline constexpr int refinement_ratio = 2;
/// Tolerances shrink by this: an error of second order in the cells then stays in proportion.
inline constexpr int tolerance_ratio = 4;

/// Of a list like "x,z"; without one the grid of the scene's model, or t where it has none. Throws core::ConfigError for
/// letters that are none of x, z, t and for directions that the model does not have.
Refinement refinement_of(const std::optional<std::string>& directions, const Scene& scene);

/// The scene's own grid and tolerances, and n - 1 refinements of them, as a dimension "level" of a sweep.
sweep::Dimension levels_of(const Scene& scene, const Refinement& refinement, int n);

}  // namespace talus::app
