#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep_plan.hpp"
#include "core/errors.hpp"
#include "output/folder_lock.hpp"
#include "sweep/manifest.hpp"
#include "sweep/runner.hpp"
#include "sweep/sweep_folder.hpp"

namespace talus::app {

/// Path of this program.
std::string own_path();

/// The folder of a sweep, ours alone while this lives, with the scenes of all members and the manifest in it.
class SweepWork {
 public:
  /// `source`: what the sweep was made from, for the manifest. `force`: members whose scene has changed are run again; else
  /// such a folder is refused. Throws core::OutputError.
  SweepWork(const SweepPlan& plan, const std::string& source, const std::filesystem::path& out, bool force);

  [[nodiscard]] const sweep::SweepFolder& folder() const { return folder_; }
  [[nodiscard]] const sweep::Manifest& manifest() const { return manifest_; }
  /// Runs the members that are not finished, `jobs` at a time (0: one on each core), and prints what became of all. Returns ok
  /// where all are finished, members_failed, or restartable after SIGINT, SIGTERM or SIGHUP: the same command goes on.
  /// `attempts`: of a member that fails.
  core::ExitCode run(int jobs, int attempts = 2);
  /// The same with nothing printed, but told to `watch`; each member is tried once, those that failed before are left so.
  /// Returns the signal that stopped it, or 0.
  int run_once(int jobs, sweep::RunnerWatch& watch);

 private:
  std::vector<std::string> scenes_;
  sweep::SweepFolder folder_;
  output::FolderLock lock_;
  sweep::Manifest manifest_;
};

}  // namespace talus::app
