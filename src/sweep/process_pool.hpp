#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace talus::sweep {

/// A program to start, without a shell.
struct Command {
  std::vector<std::string> arguments;  ///< the program's path first
  std::filesystem::path console;       ///< gets its stdout and stderr, appended
};

/// Child processes, each in a process group of its own, so that a Ctrl-C in the terminal reaches only the parent, which
/// passes on what it wants. Their standard input is empty. They start with SIGTERM blocked, so that one that comes before
/// they can answer it waits: the program must unblock it (app::Interrupt does).
class ProcessPool {
 public:
  struct Ended {
    std::size_t id;
    int code;  ///< exit code, or 128 + the signal that ended it
  };

  ProcessPool() = default;
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;
  /// Kills what still runs.
  ~ProcessPool();

  /// Throws core::OutputError(io_setup).
  void start(std::size_t id, const Command& command);
  /// Those that have ended since the last call; does not wait.
  std::vector<Ended> ended();
  void send(int signal) const;
  [[nodiscard]] std::size_t running() const { return children_.size(); }

 private:
  struct Child {
    std::size_t id;
    pid_t process;
  };
  std::vector<Child> children_;
};

}  // namespace talus::sweep
