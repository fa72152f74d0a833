#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "steady/uniform_flow.hpp"

namespace talus::app {

/// What the exact steady solutions of rung 0 say of a scene, and how its grid stands against them.
struct Theory {
  /// The steady state that the scene should reach; absent where theory knows none, then `reason` says why.
  struct Steady {
    steady::UniformFlow flow;
    bool heap;         ///< on a heap's own slope; else over the base
    double depth;      ///< in which the speed falls to 1 % of that at the surface [m]
    double thickness;  ///< expected, where the layer is thickest [m]
    double layers;     ///< of the grid within `depth`, where it is thickest
    std::optional<double>
        regularised_slope;  ///< of a heap, with the scene's u_c and regularisations, half as thick [rad]
  };
  std::optional<Steady> steady;
  std::string reason;
  std::vector<std::string> warnings;  ///< what the user should know before the run
};

/// Fewest layers within the flowing depth that a grid may have without a warning: with 4, trials kept the slope of a
/// heap within 0.6 degrees.
inline constexpr double fewest_layers = 4.0;

/// The steady state is that of the box as it stands at the end, and of the last flow that its inlet passes; the grid is held against the
/// strongest that they pass.
Theory theory_of(const Scene& scene);

/// The grains between the walls of the box as stated.
steady::Channel channel_of(const Scene& scene);

}  // namespace talus::app
