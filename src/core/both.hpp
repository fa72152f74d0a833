#pragma once

#include <atomic>
#include <exception>
#include <thread>

namespace talus::core {

/// A second thread that stays with the thread that first asked for it, so that work of a millisecond need not wait for one to be
/// started. It watches out for work for some microseconds and sleeps from then on.
class Companion {
 public:
  Companion();
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;
  ~Companion();

  /// That of this thread; null where the system refuses one or while it is at work.
  static Companion* at_leisure();
  /// Begins call(what) on the second thread.
  void begin(void (*call)(void*), void* what);
  /// Returns when it has ended, with the exception that it ended by, if any.
  std::exception_ptr end();

 private:
  enum State : int { idle, work, done, stop };
  void serve();
  /// Waits until the state is `wanted` or stop, and returns it.
  State await(State wanted);

  std::atomic<int> state_{idle};
  bool busy_ = false;  ///< as its owner sees it
  void (*call_)(void*) = nullptr;
  void* what_ = nullptr;
  std::exception_ptr failure_;
  std::thread thread_;
};

/// Runs `first` here and `second` on a companion thread; one after the other where `in_threads` is false, the system
/// refuses another thread, or that of this thread is at work. Returns when both have ended, and rethrows the exception of
/// `first` before that of `second`.
template <class First, class Second>
void both(bool in_threads, First&& first, Second&& second) {
  Companion* companion = in_threads ? Companion::at_leisure() : nullptr;
  if (companion == nullptr) {
    first();
    second();
    return;
  }
  auto work = [&] { second(); };
  companion->begin([](void* what) { (*static_cast<decltype(work)*>(what))(); }, &work);
  std::exception_ptr failure;
  try {
    first();
  } catch (...) { failure = std::current_exception(); }
  const std::exception_ptr other = companion->end();
  if (failure) std::rethrow_exception(failure);
  if (other) std::rethrow_exception(other);
}

}  // namespace talus::core
