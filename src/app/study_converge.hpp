#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::app {

struct ConvergeRequest {
  std::filesystem::path scene_file;
  std::vector<std::string> overrides;        ///< "key=value"
  std::optional<std::filesystem::path> out;  ///< else out/<scene name>_converge
  int levels = 4;
  std::optional<std::string> directions;  ///< "x,z,t"; without: the grid
  int jobs = 0;                           ///< members at a time; 0: one on each core
  bool force = false;                     ///< run levels again whose scene has changed
  std::string command;                    ///< as typed, for the provenance
};

/// `talus study converge`: the scene on refined grids, each a member of a sweep; then study.nc, verdict.json and study.png in its
/// folder and a table on the terminal. Returns the program's exit code: 0 whatever the verdict; members_failed where levels failed
/// (the others are reported); restartable after a signal. Throws core::Error.
int study_converge(const ConvergeRequest& request);

}  // namespace talus::app
