#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "sweep/design.hpp"

namespace talus::app {

struct GrowthRequest {
  const std::filesystem::path& scene_file;
  const std::vector<std::string>& overrides;  ///< "key=value"
  const Scene& scene;
  std::filesystem::path folder;  ///< of the members
  int levels;                    ///< grids: the scene's own and its refinements by 2
  std::vector<int> waves;        ///< whole waves over the box that are disturbed alone
  int jobs;                      ///< 0: one on each core
  bool force;
};

/// One disturbance on one grid, to be run.
struct GrowthMember {
  std::string name;  ///< "noise": waves and profiles of the coarsest grid; "grid noise": of this grid; "wave 3"
  int columns, layers;
  layer::Disturbance disturbance;
  double predicted;  ///< fastest growth of the disturbed waves, from the modes of this grid [1/s]
  double duration;   ///< [s]
};

/// The scene on the grid of a level, its layer's cells halved so often.
Scene refined(Scene scene, int level);

/// Growth rate [1/s] of the fastest mode of each wave along x that the scene's grid carries, m = 1, 2, ...; NaN for one without. Kept in
/// `folder` and read again for the same scene. Throws what SteadyLayer throws.
std::vector<double> rates_of_waves(const Scene& scene, const std::filesystem::path& folder, int jobs);

/// Of each grid, the coarsest first, the same disturbances: noise, grid noise, each single wave. Throws core::ConfigError for waves that the
/// coarsest grid does not carry and for scenes that are no uniform layer.
std::vector<GrowthMember> growth_members(const GrowthRequest& request);

/// They as points of a sweep's dimension "growth_run": grid, disturbance, end, records and steps.
sweep::Dimension dimension_of(const std::vector<GrowthMember>& members, const Scene& scene);

}  // namespace talus::app
