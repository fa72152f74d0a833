#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "core/integrator.hpp"

namespace talus::app {

/// Tells on a stream how far a run is: a bar on a terminal, a plain line every few seconds elsewhere.
class Progress {
 public:
  /// From `start` to `end` [s] of simulated time.
  Progress(double start, double end, std::FILE* stream);
  /// Prints if enough wall time has passed since the last time.
  void show(const core::Snapshot& snapshot);
  /// Ends the bar's line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  double start_, end_;
  std::FILE* stream_;
  bool terminal_;
  Clock::time_point begin_;
  Clock::time_point last_;
  bool shown_ = false;
};

/// "[#####.....]" of `width` cells, `fraction` in [0, 1] of them full.
std::string bar(double fraction, int width);
/// Seconds as "42 s", "3 min 05 s" or "2 h 07 min".
std::string duration(double seconds);

}  // namespace talus::app
