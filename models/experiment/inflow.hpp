#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiment/experiment.hpp"

namespace talus::experiment {

/// Mass poured per second at time t [kg/s]: 0 before `start`; each change of the inlet is followed by a C2 quintic ramp.
inline double inflow_rate(const Inflow& inflow, double t) {
  const auto ramp = [&](double since) {
    const double s = inflow.ramp > 0.0 ? since / inflow.ramp : (since > 0.0 ? 1.0 : 0.0);
    if (s <= 0.0) return 0.0;
    if (s >= 1.0) return 1.0;
    return s * s * s * (10.0 + s * (6.0 * s - 15.0));
  };
  double share = 1.0, last = 1.0;
  for (std::size_t i = 0; i < inflow.times.size(); ++i) {
    share += (inflow.shares[i] - last) * ramp(t - inflow.times[i]);
    last = inflow.shares[i];
  }
  return inflow.rate * share * (ramp(t - inflow.start) - ramp(t - inflow.stop));
}

/// What the open inlet passes by the share in force at time t, ramps apart [kg/s]; from `stop` on the last before it.
inline double open_rate(const Inflow& inflow, double t) {
  double share = 1.0;
  for (std::size_t i = 0; i < inflow.times.size(); ++i)
    if (inflow.times[i] <= t && inflow.times[i] < inflow.stop) share = inflow.shares[i];
  return inflow.rate * share;
}

/// The most that the inlet ever passes [kg/s].
inline double largest_rate(const Inflow& inflow) {
  double most = open_rate(inflow, inflow.start);
  for (const double t : inflow.times) most = std::max(most, open_rate(inflow, std::max(t, inflow.start)));
  return most;
}

/// Times [s], ascending, at which the rate is not smooth.
inline std::vector<double> breakpoints(const Inflow& inflow) {
  if (!(inflow.rate > 0.0)) return {};
  std::vector<double> times = inflow.times;
  for (const double t : {inflow.start, inflow.stop})
    if (std::isfinite(t)) times.push_back(t);
  std::ranges::sort(times);
  times.erase(std::ranges::unique(times).begin(), times.end());
  return times;
}

}  // namespace talus::experiment
