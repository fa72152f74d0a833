#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "config/problems.hpp"
#include "fit/problem.hpp"

namespace talus::app {

/// The numbers of run.nc of which a [[series]] may be.
[[nodiscard]] std::vector<std::string> series_quantities();

/// Appends what the files of [[shape]] and [[series]] hold to the stage's data: CSV, or run files of Talus. Times and places must
/// lie in the scene. Adds what is wrong with the tables to `problems`; throws core::ConfigError for what is wrong in files.
void read_layer_data(const config::Values& values, const std::filesystem::path& folder,
                     const std::filesystem::path& scene_file, const Scene& scene, fit::LayerStage& stage,
                     config::Problems& problems);

}  // namespace talus::app
