#pragma once

#include <filesystem>

#include "app/fit_file.hpp"
#include "config/problems.hpp"

namespace talus::app {

/// Adds the keys of a fit's second stage: its section, its kinds of data.
void add_layer_keys(config::Schema& schema);

/// The key of a scene that holds a parameter of the steady flow: "wall.mu_w" for mu_w.
[[nodiscard]] std::string scene_key(steady::Parameter parameter);

/// Reads the second stage, where the file has one, into `out`, whose unknowns are known already; `own` are the tables of
/// [[unknown]] whose parameter is a key of the scene. Adds what is wrong to `problems`; throws core::ConfigError for files that
/// cannot be read.
void read_layer(const config::Values& values, const std::filesystem::path& folder,
                const std::vector<const config::Values*>& own, FitFile& out, config::Problems& problems);

}  // namespace talus::app
