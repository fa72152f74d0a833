#pragma once

#include <fcntl.h>
#include <linux/capability.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace talus::support {

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What a program is allowed.
struct Limits {
  rlim_t file_size = RLIM_INFINITY;      ///< [byte] no file it writes may grow beyond
  rlim_t address_space = RLIM_INFINITY;  ///< [byte]
  bool one_core = false;
  bool obeys_permissions = false;  ///< of files, also where the tests run as root
  std::string preload = {};        ///< a library that stands in for the system
};

/// In the program itself, before it is executed.
inline void impose(const Limits& limits) {
  const rlimit file_size{limits.file_size, limits.file_size}, address_space{limits.address_space, limits.address_space};
  setrlimit(RLIMIT_FSIZE, &file_size);
  setrlimit(RLIMIT_AS, &address_space);
  if (limits.one_core) {
    cpu_set_t cores;
    sched_getaffinity(0, sizeof cores, &cores);
    int first = 0;
    while (!CPU_ISSET(first, &cores)) ++first;
    CPU_ZERO(&cores);
    CPU_SET(first, &cores);
    sched_setaffinity(0, sizeof cores, &cores);
  }
  if (!limits.preload.empty()) setenv("LD_PRELOAD", limits.preload.c_str(), 1);
  if (limits.obeys_permissions) {
    for (const int capability : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH}) prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
  }
}

/// A program started with its output in a file, waited for at the latest by the destructor, which kills it.
class Program {
 public:
  Program(const std::string& executable, std::vector<std::string> arguments, const Limits& limits = {}) {
    arguments.insert(arguments.begin(), executable);
    std::vector<char*> raw;
    for (auto& argument : arguments) raw.push_back(argument.data());
    raw.push_back(nullptr);
    const std::string said = output_file().string();
    child_ = fork();
    if (child_ < 0) throw std::runtime_error("cannot start " + executable);
    if (child_ > 0) return;
    const int file = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    impose(limits);
    execv(executable.c_str(), raw.data());
    _exit(126);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }

  [[nodiscard]] pid_t id() const { return child_; }
  void send(int signal) const { kill(child_, signal); }
  /// Exit code, or 1000 + signal where one ended the program.
  int wait() {
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  [[nodiscard]] bool running() {
    siginfo_t info{};
    return child_ > 0 && waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == 0;
  }
  /// All that it wrote to stdout and stderr.
  [[nodiscard]] std::string output() const { return contents(output_file()); }

 private:
  [[nodiscard]] std::filesystem::path output_file() const { return folder_ / "output"; }
  TemporaryFolder folder_;
  pid_t child_ = 0;
};

/// What a program that ran to its end said and returned.
struct Outcome {
  int code;
  std::string output;
};

inline Outcome outcome_of(const std::string& executable, std::vector<std::string> arguments,
                          const Limits& limits = {}) {
  Program program(executable, std::move(arguments), limits);
  const int code = program.wait();
  return {code, program.output()};
}

}  // namespace talus::support
