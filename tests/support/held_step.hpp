#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "ida/ida.hpp"

namespace talus::tests {

/// Options under which IDA keeps the order `order` and the step `step` [s] once it has reached them. It gets there from a
/// step 2^-`doublings` of that, by doublings, so that the first steps at order 1 do not show in the error. Tolerances must be
/// so loose that the error test always passes, and Newton's method goes to `newton_tolerance` of them.
inline ida::Options held_step(int order, double step, double rtol, double newton_tolerance, int doublings = 0) {
  ida::Options options;
  options.rtol = rtol;
  options.max_order = order;
  options.max_step = step;
  options.initial_step = std::ldexp(step, -doublings);
  options.newton.tolerance = newton_tolerance;
  return options;
}

/// Watches a run with a held step: calls `look` after each step at the full order and step, and counts those that are not,
/// once the first has been seen.
class HeldStepObserver final : public core::Observer {
 public:
  HeldStepObserver(int order, double step, std::function<void(const core::Snapshot&)> look)
      : order_(order), step_(step), look_(std::move(look)) {}

  bool on_step(const core::Snapshot& now) override {
    const bool held = now.statistics.order == order_ && std::abs(now.statistics.last_step / step_ - 1.0) < 1e-9;
    if (held) ++n_held;
    if (!held && n_held > 0) ++n_lost;
    if (held) look_(now);
    return true;
  }

  long n_held = 0;  ///< steps at the full order and step
  long n_lost = 0;  ///< others after the first of them

 private:
  int order_;
  double step_;
  std::function<void(const core::Snapshot&)> look_;
};

}  // namespace talus::tests
