#pragma once

#include <csignal>

namespace talus::app {

/// While alive, SIGINT and SIGTERM ask for a clean stop after the current step, SIGUSR1 for a checkpoint. A second SIGINT
/// (or SIGTERM) ends the program at once. Where the program was started with them blocked, what has come until now is
/// heard now. At most one object at a time.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();
  /// The signal that asked to stop, or 0.
  [[nodiscard]] int stop() const;
  /// A checkpoint was asked for and is not yet answered.
  [[nodiscard]] bool save() const;
  void answered_save();

 private:
  struct sigaction old_interrupt_ {};
  struct sigaction old_terminate_ {};
  struct sigaction old_user_ {};
  sigset_t old_mask_{};
};

}  // namespace talus::app
