#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::app {

/// A named trade of accuracy for time: how much coarser than its file states it a scene is run.
struct Preset {
  std::string name;
  std::string doc;
  int columns_divisor, layers_divisor;
  double rtol_factor;
  std::string
      measured;  ///< error and cost on runs/examples/heap_q46.toml, whole 320 s, against the exact slope and its fine grid
};

/// From the cheapest to the dearest.
const std::vector<Preset>& presets();
std::vector<std::string> preset_names();

/// `overrides` ("key=value") with the preset's own before them: cells divided, never below 8 columns and 4 layers where the scene has
/// more, and the relative tolerance. What `overrides` set themselves stays theirs. Precondition: `name` is one of preset_names(). Throws
/// core::ConfigError for a scene that cannot be read.
std::vector<std::string> with_preset(const std::filesystem::path& scene_file, const std::string& name,
                                     std::vector<std::string> overrides);

/// All of them with their measured errors and costs, for people.
std::string explain_presets();

}  // namespace talus::app
