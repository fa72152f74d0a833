#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace talus::app {

/// Calls `work(i)` for i = 0 .. n - 1 on `jobs` threads (0: one on each core), each i once, in any order; one after another where the system refuses threads. Throws what one of them throws, after all have ended.
template <class Work>
void side_by_side(std::size_t n, int jobs, const Work& work) {
  const auto threads = static_cast<std::size_t>(jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency()));
  std::vector<std::future<void>> workers;
  for (std::size_t first = 0; first < std::min(n, threads); ++first)
    workers.push_back(std::async(std::launch::async | std::launch::deferred, [&work, first, n, threads] {
      for (std::size_t i = first; i < n; i += threads) work(i);
    }));
  for (auto& worker : workers) worker.wait();
  for (auto& worker : workers) worker.get();
}

}  // namespace talus::app
