#pragma once

#include <filesystem>

namespace talus::output {

/// Holds a folder against other processes of Talus while it lives: a lock of the system on the folder itself, so that
/// nothing stays behind a killed program.
class FolderLock {
 public:
  /// Throws core::OutputError(io_setup) where the folder cannot be opened or written to, core::Error(locked) where another
  /// process holds it; `who` says what that one is, for example "another run".
  FolderLock(const std::filesystem::path& folder, const char* who);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int handle_ = -1;
};

}  // namespace talus::output
