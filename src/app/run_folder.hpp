#pragma once

#include <filesystem>

#include "output/checkpoint_folder.hpp"

namespace talus::app {

/// What a run wants of its folder: a new one; one whose earlier run goes; one whose earlier run goes on.
enum class Claim { fresh, replace, proceed };

/// The folder of one run, created and held against other runs while this object lives.
class RunFolder {
 public:
  /// Throws core::OutputError(io_setup) for a folder that cannot be made or written to, or that holds a run already where
  /// a fresh one is wanted; OutputError(bad_restart) where it holds no run that could proceed; core::Error(locked) where
  /// another run is writing to it. With `replace` the old run's files go.
  RunFolder(std::filesystem::path path, Claim claim);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path data() const { return path_ / "run.nc"; }
  [[nodiscard]] std::filesystem::path scene() const { return path_ / "scene.toml"; }
  [[nodiscard]] std::filesystem::path log() const { return path_ / "run.log"; }
  [[nodiscard]] std::filesystem::path summary() const { return path_ / "summary.json"; }
  [[nodiscard]] output::CheckpointFolder checkpoints() const { return output::CheckpointFolder(path_); }
  /// The command that continues the run in this folder.
  [[nodiscard]] std::string restart_command() const { return "talus restart " + path_.string(); }
  /// Throws core::OutputError(output_failed) where the folder is gone, or another one stands in its place: that may be
  /// another run's.
  void check_in_place() const;
  /// Removes all that a run leaves but its scene. Throws core::OutputError(io_setup).
  void remove_results() const;

 private:
  void take(Claim claim);
  void refuse_an_earlier_run() const;
  void remove_leftovers() const;

  std::filesystem::path path_;
  int handle_ = -1;  ///< of the folder, carrying the lock
};

}  // namespace talus::app
