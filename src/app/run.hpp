#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::app {

struct RunRequest {
  std::filesystem::path scene_file;
  std::vector<std::string> overrides;        ///< "key=value"
  std::optional<std::filesystem::path> out;  ///< else out/<scene name>
  bool force = false;                        ///< replace an earlier run in that folder
  std::string command;                       ///< as typed, for the provenance
};

/// Integrates a scene and writes run.nc, scene.toml, run.log and, last of all and whatever happens, summary.json.
/// Returns the program's exit code: 0, or 128 + signal after a run that was stopped by SIGINT or SIGTERM. Such a run
/// cannot be continued, hence not 75. Throws core::Error and what the model throws, after it has written the summary.
int run(const RunRequest& request);

}  // namespace talus::app
