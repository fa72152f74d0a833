#pragma once

#include <span>
#include <string>
#include <vector>

#include "kinsol/newton.hpp"

namespace talus::kinsol {

/// Pseudo-transient continuation: implicit Euler steps from y towards the steady state at frozen time t. Their size grows
/// as they converge and is cut where they do not; no local error is controlled. Where a step changes little, the steady
/// state itself is tried from there.
/// (C. T. Kelley and D. E. Keyes, SIAM J. Numer. Anal. 35, 1998.)
class Continuation {
 public:
  /// All must outlive this.
  Continuation(Newton& newton, const Options& options, core::Statistics& statistics)
      : newton_(newton), options_(options), statistics_(statistics) {}

  /// Moves y (shape n) to the steady state of time t. False where that fails: y is then the last state reached, and why()
  /// says how it ended. Throws what the system throws.
  bool run(double t, std::span<double> y);
  [[nodiscard]] const std::string& why() const { return why_; }

 private:
  Newton& newton_;
  const Options& options_;
  core::Statistics& statistics_;
  std::string why_;
};

}  // namespace talus::kinsol
