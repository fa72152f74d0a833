#include "app/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "core/errors.hpp"

namespace talus::app {
namespace {

using core::ExitCode;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw core::OutputError(ExitCode::io_setup, "output folder " + path.string() + ": " + why);
}

}  // namespace

RunFolder::RunFolder(std::filesystem::path path, bool force) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) refuse(path_, "cannot be created: " + error.message());
  handle_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle_ < 0) refuse(path_, "cannot be opened: " + std::string(std::strerror(errno)));
  if (access(path_.c_str(), W_OK | X_OK) != 0) {
    const std::string why = std::strerror(errno);
    close(handle_);
    refuse(path_, "cannot be written to: " + why);
  }
  if (flock(handle_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(handle_);
    throw core::Error(ExitCode::locked, "output folder " + path_.string() + ": another run is writing to it");
  }
  const auto files = {data(), scene(), log(), summary()};
  for (const auto& file : files) {
    if (!force && std::filesystem::exists(file)) {
      close(handle_);
      refuse(path_,
             "holds a run already (" + file.filename().string() + "); --force replaces it, --out names another folder");
    }
  }
  for (const auto& file : files) {
    std::filesystem::remove(file, error);
    if (error) {
      close(handle_);
      refuse(path_, file.filename().string() + " of the earlier run cannot be removed: " + error.message());
    }
  }
}

RunFolder::~RunFolder() { close(handle_); }

}  // namespace talus::app
