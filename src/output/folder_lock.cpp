#include "output/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/errors.hpp"

namespace talus::output {
namespace {

/// Closes the folder and throws with the words of `errno`.
[[noreturn]] void refuse(int handle, const std::filesystem::path& folder, const std::string& what) {
  const std::string why = std::strerror(errno);
  if (handle >= 0) close(handle);
  throw core::OutputError(core::ExitCode::io_setup, "output folder " + folder.string() + ": " + what + ": " + why);
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, const char* who)
    : handle_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (handle_ < 0) refuse(handle_, folder, "cannot be opened");
  if (access(folder.c_str(), W_OK | X_OK) != 0) refuse(handle_, folder, "cannot be written to");
  if (flock(handle_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;  // some network drives know no locks
  close(handle_);
  throw core::Error(core::ExitCode::locked, "output folder " + folder.string() + ": " + who + " is writing to it");
}

FolderLock::~FolderLock() { close(handle_); }

}  // namespace talus::output
