#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sweep/engines.hpp"

namespace talus::app {

struct SweepRequest {
  std::filesystem::path file;
  std::vector<std::string> overrides;        ///< "key=value", for all members
  std::optional<std::filesystem::path> out;  ///< else out/<sweep name>
  int jobs = 0;                              ///< members at a time; 0: one on each core
  bool force = false;                        ///< run members again whose scene has changed
  bool dry_run = false;                      ///< check and describe, run nothing
  std::optional<sweep::Engine> engine;       ///< write a script for it, run nothing
};

/// Runs the members of a sweep that are not finished, each as a process of `talus member`. Returns the program's exit code:
/// 0 where all members are finished, members_failed, or restartable after SIGINT, SIGTERM or SIGHUP: the same command
/// goes on. Throws core::Error.
int sweep(const SweepRequest& request);

/// Runs one member of a sweep's folder in this process, or goes on with it where it can (sweep::next_action), unless it
/// is finished: what sweeps and the scripts for other engines call.
/// Returns the exit code of its run. Throws what run() and restart()
/// throw; core::ConfigError where there is no such member.
int run_member(const std::filesystem::path& folder, std::size_t member, const std::string& command);

}  // namespace talus::app
