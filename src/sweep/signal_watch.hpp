#pragma once

#include <csignal>

namespace talus::sweep {

/// While alive, SIGINT, SIGTERM and SIGHUP (unless it was ignored, as under nohup) do not end the program but are told by
/// wait(), and so is the end of a child. At most one object at a time.
class SignalWatch {
 public:
  SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch();
  /// Waits for the next signal, at most `seconds`. Returns its number, SIGCHLD among them, or 0.
  [[nodiscard]] int wait(double seconds) const;

 private:
  sigset_t watched_{};
  sigset_t before_{};
  struct sigaction child_before_ {};
};

}  // namespace talus::sweep
