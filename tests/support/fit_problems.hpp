#pragma once

#include <numbers>
#include <random>
#include <vector>

#include "fit/fit.hpp"
#include "steady/slope.hpp"

namespace talus::support {

inline constexpr double degree = std::numbers::pi / 180.0;

/// Table 2, with the law asked for.
inline steady::VariedChannel table_2(bool partial = true) {
  const rheology::Classical base{0.4, 0.9, 1.3};
  steady::VariedChannel out{{{2500.0, 0.6, 0.00073}, base, 0.003, 0.3727, 9.81}};
  if (partial) out.channel.law = rheology::partially_regularised(base, 1.3, 1.9, 0.05178);
  return out;
}

/// Measurements that a channel would give, with normal errors of these standard deviations; no seed: none.
class Laboratory {
 public:
  explicit Laboratory(steady::VariedChannel truth, unsigned seed = 0)
      : truth_(std::move(truth)), engine_(seed), noisy_(seed > 0) {}

  fit::SlopePoint slope(double Q, double error_deg) {
    return {Q, 0.0, *steady::slope_of_flux(truth_.channel, Q) + noise() * error_deg * degree, error_deg * degree,
            "slope"};
  }
  /// Ten speeds down to 4 mm below a surface that was taken too low by `offset` [m].
  fit::SpeedProfile profile(double Q, double error, double offset = 0.0, int points = 10) {
    const auto flow = steady::flow_of_flux(truth_.channel, Q).value();
    fit::SpeedProfile out{"profile", Q, {}, {}, {}, {}, offset == 0.0 ? 0.0 : 1e-3};
    for (int i = 0; i < points; ++i) {
      out.depth.push_back(2e-4 + 0.004 * i / points);
      out.speed.push_back(flow.speed(-(out.depth.back() + offset)) + noise() * error);
      out.error.push_back(error);
    }
    return out;
  }

 private:
  double noise() { return noisy_ ? normal_(engine_) : 0.0; }
  steady::VariedChannel truth_;
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
  bool noisy_;
};

inline fit::Unknown unknown(steady::Parameter p, double start, double low, double high) {
  return {p, start, low, high, {}};
}

}  // namespace talus::support
