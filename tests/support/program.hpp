#pragma once

#include <fcntl.h>
#include <signal.h>
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

/// A program started with its output in a file, waited for at the latest by the destructor, which kills it.
class Program {
 public:
  /// `file_size_limit` [byte]: no file it writes may grow beyond; 0: no limit.
  Program(const std::string& executable, std::vector<std::string> arguments, rlim_t file_size_limit = 0) {
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
    const rlimit limit{file_size_limit, file_size_limit};
    if (file_size_limit > 0) setrlimit(RLIMIT_FSIZE, &limit);
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
                          rlim_t file_size_limit = 0) {
  Program program(executable, std::move(arguments), file_size_limit);
  const int code = program.wait();
  return {code, program.output()};
}

}  // namespace talus::support
