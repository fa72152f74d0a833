#pragma once

#include <future>

namespace talus::core {

/// Runs `first` here and `second` on a thread of its own; one after the other where `in_threads` is false or the system
/// refuses another thread. Returns when both have ended, and rethrows the exception of `first` before that of `second`.
template <class First, class Second>
void both(bool in_threads, First&& first, Second&& second) {
  if (!in_threads) {
    first();
    second();
    return;
  }
  // Where it may defer, libstdc++ runs `second` in get() if no thread can be had.
  auto other = std::async(std::launch::async | std::launch::deferred, [&] { second(); });
  first();
  other.get();
}

}  // namespace talus::core
