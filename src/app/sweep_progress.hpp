#pragma once

#include <chrono>
#include <cstdio>

#include "sweep/runner.hpp"

namespace talus::app {

/// Tells on a stream how far a sweep is: a bar on a terminal, with failures above it; elsewhere a line for each member.
class SweepProgress : public sweep::RunnerWatch {
 public:
  /// `design` must outlive this; `n_skipped` members need no run.
  SweepProgress(const sweep::Design& design, std::size_t n_skipped, std::FILE* stream);
  void ended(std::size_t member, const sweep::MemberState& state, bool again) override;
  void idle(std::size_t running, std::size_t left) override;
  /// Ends the bar's line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  const sweep::Design& design_;
  std::size_t n_skipped_;
  std::size_t n_ended_ = 0;
  std::size_t n_failed_ = 0;
  std::FILE* stream_;
  bool terminal_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace talus::app
