#include "app/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "core/errors.hpp"

namespace talus::app {
namespace {

using core::ExitCode;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why,
                         ExitCode code = ExitCode::io_setup) {
  throw core::OutputError(code, "output folder " + path.string() + ": " + why);
}

}  // namespace

RunFolder::RunFolder(std::filesystem::path path, Claim claim) : path_(std::move(path)) {
  std::error_code error;
  if (claim != Claim::proceed) std::filesystem::create_directories(path_, error);
  if (error) refuse(path_, "cannot be created: " + error.message());
  handle_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle_ < 0)
    refuse(path_, "cannot be opened: " + std::string(std::strerror(errno)),
           claim == Claim::proceed ? ExitCode::bad_restart : ExitCode::io_setup);
  try {
    take(claim);
  } catch (...) {
    close(handle_);
    throw;
  }
}

RunFolder::~RunFolder() { close(handle_); }

void RunFolder::check_in_place() const {
  struct stat held {
  }, found{};
  const bool in_place = fstat(handle_, &held) == 0 && stat(path_.c_str(), &found) == 0 && held.st_dev == found.st_dev &&
                        held.st_ino == found.st_ino;
  if (!in_place) refuse(path_, "was removed or replaced during the run", ExitCode::output_failed);
}

void RunFolder::take(Claim claim) {
  if (access(path_.c_str(), W_OK | X_OK) != 0)
    refuse(path_, "cannot be written to: " + std::string(std::strerror(errno)));
  if (flock(handle_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw core::Error(ExitCode::locked, "output folder " + path_.string() + ": another run is writing to it");
  remove_leftovers();
  if (claim == Claim::fresh) refuse_an_earlier_run();
  if (claim == Claim::proceed && !std::filesystem::exists(scene()))
    refuse(path_, "holds no run to go on with (no scene.toml)", ExitCode::bad_restart);
  if (claim == Claim::replace) {
    remove_results();
    std::error_code error;
    std::filesystem::remove(scene(), error);
    if (error) refuse(path_, "scene.toml of the earlier run cannot be removed: " + error.message());
  }
}

void RunFolder::refuse_an_earlier_run() const {
  const auto found = checkpoints().newest();
  std::string what = "holds a run already";
  if (found.checkpoint) {
    std::array<char, 64> words{};
    std::snprintf(words.data(), words.size(), ", with a checkpoint at t = %.6g s", found.checkpoint->t);
    refuse(path_, what + words.data() + ": `" + restart_command() +
                      "` goes on from there; --force begins anew, --out names another folder");
  }
  for (const auto& file : {data(), scene(), log(), summary()}) {
    if (std::filesystem::exists(file))
      refuse(path_, what + " (" + file.filename().string() + "); --force replaces it, --out names another folder");
  }
}

/// What a killed run was writing beside its place.
void RunFolder::remove_leftovers() const {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(path_, ignored)) {
    if (entry.path().filename().string().find(".part-") != std::string::npos)
      std::filesystem::remove(entry.path(), ignored);
  }
}

void RunFolder::remove_results() const {
  try {
    checkpoints().clear();
    for (const auto& file : {data(), log(), summary()}) std::filesystem::remove(file);
  } catch (const std::filesystem::filesystem_error& error) {
    refuse(path_,
           error.path1().filename().string() + " of the earlier run cannot be removed: " + error.code().message());
  }
}

}  // namespace talus::app
