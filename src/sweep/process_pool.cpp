#include "sweep/process_pool.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "core/errors.hpp"

namespace talus::sweep {
namespace {

/// Owns what posix_spawn wants to know.
class SpawnSettings {
 public:
  explicit SpawnSettings(const std::filesystem::path& console) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, console.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
    posix_spawn_file_actions_adddup2(&files_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    sigset_t blocked, all;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &blocked);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  [[nodiscard]] const posix_spawn_file_actions_t* files() const { return &files_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

ProcessPool::~ProcessPool() {
  send(SIGKILL);
  for (const auto& child : children_) waitpid(child.process, nullptr, 0);
}

void ProcessPool::start(std::size_t id, const Command& command) {
  std::vector<std::string> arguments = command.arguments;
  std::vector<char*> raw;
  for (auto& argument : arguments) raw.push_back(argument.data());
  raw.push_back(nullptr);
  const SpawnSettings settings(command.console);
  Child child{id, 0};
  const int failed =
      posix_spawn(&child.process, raw.front(), settings.files(), settings.attributes(), raw.data(), environ);
  if (failed != 0) {
    throw core::OutputError(core::ExitCode::io_setup, arguments.front() + " cannot be started with its output in " +
                                                          command.console.string() + ": " + std::strerror(failed));
  }
  children_.push_back(child);
}

std::vector<ProcessPool::Ended> ProcessPool::ended() {
  std::vector<Ended> ended;
  std::erase_if(children_, [&](const Child& child) {
    int status = 0;
    if (waitpid(child.process, &status, WNOHANG) != child.process) return false;
    constexpr int signal_base = 128;
    ended.push_back({child.id, WIFEXITED(status) ? WEXITSTATUS(status) : signal_base + WTERMSIG(status)});
    return true;
  });
  return ended;
}

void ProcessPool::send(int signal) const {
  for (const auto& child : children_) kill(child.process, signal);
}

}  // namespace talus::sweep
