#include "kinsol/continuation.hpp"

#include <algorithm>
#include <sstream>

namespace talus::kinsol {

bool Continuation::run(double t, std::span<double> y) {
  const auto& limits = options_.continuation;
  std::vector<double> from(y.begin(), y.end());
  double step = limits.first_step, growth = limits.growth, last_change = 0.0;
  const auto failed = [&](const char* how) {
    std::ostringstream text;
    text << how << ", with the last of " << step << " s: " << newton_.why();
    why_ = text.str();
    return false;
  };
  for (int steps = 0; steps < limits.max_steps; ++steps) {
    std::copy(from.begin(), from.end(), y.begin());
    if (!newton_.solve({t, 1.0 / step, from}, y, limits.max_iterations)) {
      std::copy(from.begin(), from.end(), y.begin());
      step /= limits.growth;
      growth = 2.0;
      if (step < limits.least_step) return failed("the continuation's steps shrink to nothing");
      continue;
    }
    ++statistics_.restarts;
    statistics_.last_step = step;
    const double change = newton_.relative_change(from, y);
    const bool settled = change < limits.settled_below && change < last_change;
    last_change = change;
    std::copy(y.begin(), y.end(), from.begin());
    if (settled) {
      if (newton_.solve({t}, y, limits.max_iterations)) return true;
      std::copy(from.begin(), from.end(), y.begin());
    }
    step *= growth;
    growth = std::min(limits.growth, growth * growth);
  }
  return failed("the continuation's steps do not settle");
}

}  // namespace talus::kinsol
