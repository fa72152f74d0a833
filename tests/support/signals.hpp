#pragma once

#include <csignal>

#include "support/program.hpp"

namespace talus::support {

/// While alive, programs start with a signal blocked: one that comes before they unblock it waits for them.
class Blocked {
 public:
  explicit Blocked(int signal) {
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, signal);
    sigprocmask(SIG_BLOCK, &blocked, &before_);
  }
  Blocked(const Blocked&) = delete;
  Blocked& operator=(const Blocked&) = delete;
  ~Blocked() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// What a run says that is asked to stop before it has begun: it takes no step, whatever the machine is busy with.
inline Outcome stopped_at_once(const std::string& executable, const std::vector<std::string>& arguments) {
  const Blocked blocked(SIGTERM);
  Program program(executable, arguments);
  program.send(SIGTERM);
  const int code = program.wait();
  return {code, program.output()};
}

}  // namespace talus::support
