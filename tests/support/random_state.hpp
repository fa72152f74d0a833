#pragma once

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "core/dae_system.hpp"

namespace talus::tests {

/// A state about `system`'s initial one: velocities of up to `speed` [m/s], pressures from `p_least` to `p_most` times theirs (times 1 Pa where there
/// is none: p_0 = 0 has a kink there),
/// thicknesses between `H_least` and `H_most` [m], volume fractions from 0 to 1, masses up to 50 g, rates of order one. Fields the generator does not know stay as they are.
struct RandomState {
  double speed = 0.3;
  double H_least = 6e-4, H_most = 2e-2;
  double p_least = 0.5, p_most = 1.5;

  void fill(const core::DaeSystem& system, unsigned seed, std::vector<double>& y, std::vector<double>& yp) const {
    const auto& layout = system.layout();
    y.assign(layout.size(), 0.0);
    yp.assign(layout.size(), 0.0);
    system.initial_state(0.0, y, yp);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (core::Index i = 0; i < layout.size(); ++i) {
      const auto& name = layout.field(i).name;
      if (name == "u" || name == "w" || name == "omega") y[i] += speed * (2.0 * share(random) - 1.0);
      if (name == "p") y[i] = (y[i] == 0.0 ? 1.0 : y[i]) * (p_least + (p_most - p_least) * share(random));
      if (name == "phi") y[i] = share(random);
      if (name == "H") y[i] = H_least * std::pow(H_most / H_least, share(random));
      yp[i] = 2.0 * share(random) - 1.0;
    }
    for (core::Index i = 0; i < layout.size(); ++i)
      if (layout.field(i).name == "mass") y[i] += 0.05 * share(random);
  }
};

/// Largest difference of a column of the Jacobian from central differences of the residual, relative to the largest
/// entry of the column; over all columns. `worst` receives the column. The step is a share of the unknown's own size,
/// and the rate moves with it, so that the sum dF/dy + c_j dF/dy' is differenced as one. A column that disagrees is tried with a
/// longer and a shorter step, too: rounding spoils short ones, curvature long ones, a wrong Jacobian all.
inline double jacobian_error(const core::DaeSystem& system, double t, std::vector<double> y, std::vector<double> yp,
                             double c_j, core::Index& worst) {
  const auto n = static_cast<std::size_t>(system.layout().size());
  const auto& pattern = system.pattern();
  std::vector<double> values(pattern.n_nonzeros()), plus(n), minus(n), column(n);
  system.jacobian(t, y, yp, c_j, values);
  double largest = 0.0;
  for (std::size_t j = 0; j < n; ++j) {
    const auto& unit = system.layout().field(static_cast<core::Index>(j)).unit;
    std::fill(column.begin(), column.end(), 0.0);
    double scale = 0.0;
    for (auto k = pattern.column_starts()[j]; k < pattern.column_starts()[j + 1]; ++k) {
      column[pattern.rows()[k]] = values[k];
      scale = std::max(scale, std::abs(values[k]));
    }
    const auto error_with = [&](double share) {
      const double h = share * std::max(std::abs(y[j]), unit == "m" ? 1e-4 : 1e-2);
      const double at = y[j], rate = yp[j];
      y[j] = at + h, yp[j] = rate + c_j * h;
      system.residual(t, y, yp, plus);
      y[j] = at - h, yp[j] = rate - c_j * h;
      system.residual(t, y, yp, minus);
      y[j] = at, yp[j] = rate;
      double error = 0.0;
      for (std::size_t i = 0; i < n; ++i)
        error = std::max(error, std::abs((plus[i] - minus[i]) / (2.0 * h) - column[i]));
      return error;
    };
    double error = error_with(1e-6);
    for (const double share : {1e-5, 1e-7, 1e-4})
      if (error > 1e-7 * scale) error = std::min(error, error_with(share));
    if (!(error <= largest * scale)) {
      largest = error / scale;
      worst = static_cast<core::Index>(j);
    }
  }
  return largest;
}

}  // namespace talus::tests
