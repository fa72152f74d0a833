#include "sweep/signal_watch.hpp"

#include <cmath>
#include <ctime>
#include <initializer_list>

namespace talus::sweep {

SignalWatch::SignalWatch() {
  sigemptyset(&watched_);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&watched_, signal);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaddset(&watched_, SIGHUP);
  struct sigaction child {};  // where it is ignored, the system takes away the exit codes of children
  child.sa_handler = SIG_DFL;
  sigaction(SIGCHLD, &child, &child_before_);
  sigprocmask(SIG_BLOCK, &watched_, &before_);
}

SignalWatch::~SignalWatch() {
  while (wait(0.0) != 0) {
    // what came too late to be told must not end the program now
  }
  sigprocmask(SIG_SETMASK, &before_, nullptr);
  sigaction(SIGCHLD, &child_before_, nullptr);
}

int SignalWatch::wait(double seconds) const {
  const double whole = std::floor(seconds);
  const timespec most{static_cast<std::time_t>(whole), static_cast<long>(1e9 * (seconds - whole))};
  const int signal = sigtimedwait(&watched_, nullptr, &most);
  return signal > 0 ? signal : 0;
}

}  // namespace talus::sweep
