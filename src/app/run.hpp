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

/// Integrates a scene and writes run.nc, scene.toml, run.log, checkpoints and, last of all and whatever happens,
/// summary.json. Returns the program's exit code: 0, or 75 after a run that was stopped by SIGINT, SIGTERM or its wall
/// limit and that restart() continues. Throws core::Error and what the model throws, after it has written the summary.
int run(const RunRequest& request);

struct RestartRequest {
  std::filesystem::path folder;
  std::vector<std::string> overrides;  ///< "key=value", on top of the folder's scene
  std::vector<std::string> allowed;    ///< keys that may differ from the checkpoint
  std::string command;                 ///< as typed, for the provenance
};

/// Goes on with the run in a folder from its newest whole checkpoint, or from the start where it has none. The scene is the
/// one in the folder. Otherwise as run(). Throws core::OutputError(bad_restart) where the folder holds nothing to go on
/// with, where all checkpoints are damaged, or where the scene, key by key, is not that of the checkpoint.
int restart(const RestartRequest& request);

}  // namespace talus::app
