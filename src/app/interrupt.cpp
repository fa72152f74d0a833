#include "app/interrupt.hpp"

#include <initializer_list>

namespace talus::app {
namespace {

volatile std::sig_atomic_t stop_asked = 0;
volatile std::sig_atomic_t save_asked = 0;

void handle(int signal, void (*handler)(int), int more_flags, struct sigaction& old) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART | more_flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, &old);
}

}  // namespace

Interrupt::Interrupt() {
  stop_asked = 0;
  save_asked = 0;
  const auto remember = [](int signal) { stop_asked = signal; };
  constexpr int once = static_cast<int>(SA_RESETHAND);
  handle(SIGINT, remember, once, old_interrupt_);
  handle(SIGTERM, remember, once, old_terminate_);
  handle(
      SIGUSR1, [](int) { save_asked = 1; }, 0, old_user_);
  sigset_t heard;
  sigemptyset(&heard);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&heard, signal);
  sigprocmask(SIG_UNBLOCK, &heard, &old_mask_);
}

Interrupt::~Interrupt() {
  sigprocmask(SIG_SETMASK, &old_mask_, nullptr);
  sigaction(SIGINT, &old_interrupt_, nullptr);
  sigaction(SIGTERM, &old_terminate_, nullptr);
  sigaction(SIGUSR1, &old_user_, nullptr);
}

int Interrupt::stop() const { return stop_asked; }

bool Interrupt::save() const { return save_asked != 0; }

void Interrupt::answered_save() { save_asked = 0; }

}  // namespace talus::app
