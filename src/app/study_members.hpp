#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "app/sweep_plan.hpp"
#include "output/table_file.hpp"
#include "sweep/manifest.hpp"

namespace talus::app {

/// A study whose members are the points of one dimension of a sweep over a scene.
struct MemberStudy {
  std::string kind;  ///< "converge": its name after `talus study`
  std::string what;  ///< "Refinement in x of": before the scene's title
  const std::filesystem::path& scene_file;
  const std::vector<std::string>& overrides;  ///< "key=value"; of keys of the dimension, its points have the say
  const sweep::Dimension& dimension;
};

/// Throws core::ConfigError naming the members whose scene is refused.
SweepPlan plan_of(const MemberStudy& study, const Scene& scene);

/// What the members hold, with the provenance of the study, for its study.nc. `command` as typed; `verdict` in words. Throws
/// core::OutputError for a run.nc that cannot be read.
output::Table table_of(const std::string& kind, const std::filesystem::path& folder, const sweep::Manifest& manifest,
                       const std::string& command, const std::string& verdict);

}  // namespace talus::app
