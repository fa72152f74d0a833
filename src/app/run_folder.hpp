#pragma once

#include <filesystem>

namespace talus::app {

/// The folder of one run, created and held against other runs while this object lives.
class RunFolder {
 public:
  /// Throws core::OutputError(io_setup) for a folder that cannot be made or written to, or that holds a run already and
  /// `force` is false; core::Error(locked) where another run is writing to it. With `force` the old run's files go.
  RunFolder(std::filesystem::path path, bool force);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path data() const { return path_ / "run.nc"; }
  [[nodiscard]] std::filesystem::path scene() const { return path_ / "scene.toml"; }
  [[nodiscard]] std::filesystem::path log() const { return path_ / "run.log"; }
  [[nodiscard]] std::filesystem::path summary() const { return path_ / "summary.json"; }

 private:
  std::filesystem::path path_;
  int handle_ = -1;  ///< of the folder, carrying the lock
};

}  // namespace talus::app
