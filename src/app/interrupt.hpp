#pragma once

#include <csignal>

namespace talus::app {

/// While alive, SIGINT and SIGTERM ask for a clean stop after the current step. A second signal of the same kind ends
/// the program at once. At most one object at a time.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();
  /// The signal that arrived, or 0.
  [[nodiscard]] int signal() const;

 private:
  struct sigaction old_interrupt_ {};
  struct sigaction old_terminate_ {};
};

}  // namespace talus::app
