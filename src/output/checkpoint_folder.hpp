#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/checkpoint.hpp"

namespace talus::output {

/// The checkpoints of one run: checkpoint_000001.nc and so on, each beside its SHA-256 sum in checkpoint_000001.nc.sha256
/// (`sha256sum -c` reads it). The last two are kept. At any moment, also after a crash, at least one that was complete
/// is still complete.
class CheckpointFolder {
 public:
  explicit CheckpointFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Written beside its place, brought to disk, renamed; then its sum; then the oldest goes. Returns the file's name.
  /// Throws OutputError(output_failed), and as to_bytes does; the earlier ones are then untouched.
  std::string write(const Checkpoint& checkpoint);

  struct Found {
    std::optional<Checkpoint> checkpoint;  ///< the newest that is whole
    std::string file;                      ///< its name
    std::vector<std::string> damaged;      ///< newer ones: name and what is wrong
  };
  /// Reads the newest checkpoint whose sum is right: no other reader sees the bytes of a file before that.
  [[nodiscard]] Found newest() const;
  /// Removes what newest() found damaged, so that it does not count as one of the last two. Best effort.
  void remove_damaged(const Found& found);
  /// Removes all. Throws std::filesystem::filesystem_error.
  void clear();

 private:
  [[nodiscard]] std::vector<int> numbers() const;  ///< ascending
  [[nodiscard]] std::filesystem::path file(int number) const;
  void remove(int number);

  std::filesystem::path folder_;
};

}  // namespace talus::output
