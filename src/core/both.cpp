#include "core/both.hpp"

#include <memory>
#include <system_error>
#include <utility>

namespace talus::core {
namespace {

constexpr int glances = 2000;  ///< before sleeping: some 20 microseconds

void rest() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Companion::Companion() : thread_([this] { serve(); }) {}

Companion::~Companion() {
  state_.store(stop, std::memory_order_release);
  state_.notify_one();
  thread_.join();
}

Companion* Companion::at_leisure() {
  thread_local std::unique_ptr<Companion> mine;
  if (!mine) {
    try {
      mine = std::make_unique<Companion>();
    } catch (const std::system_error&) { return nullptr; }
  }
  return mine->busy_ ? nullptr : mine.get();
}

void Companion::begin(void (*call)(void*), void* what) {
  busy_ = true;
  call_ = call;
  what_ = what;
  state_.store(work, std::memory_order_release);
  state_.notify_one();
}

std::exception_ptr Companion::end() {
  await(done);
  state_.store(idle, std::memory_order_relaxed);
  busy_ = false;
  return std::exchange(failure_, nullptr);
}

Companion::State Companion::await(State wanted) {
  int state = state_.load(std::memory_order_acquire);
  const auto over = [&] { return state == wanted || state == stop; };
  for (int i = 0; i < glances && !over(); ++i) {
    rest();
    state = state_.load(std::memory_order_acquire);
  }
  while (!over()) {
    state_.wait(state, std::memory_order_acquire);
    state = state_.load(std::memory_order_acquire);
  }
  return static_cast<State>(state);
}

void Companion::serve() {
  while (await(work) == work) {
    try {
      call_(what_);
    } catch (...) { failure_ = std::current_exception(); }
    state_.store(done, std::memory_order_release);
    state_.notify_one();
  }
}

}  // namespace talus::core
