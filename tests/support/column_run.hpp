#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "column/column.hpp"
#include "column/layer_state.hpp"
#include "ida/ida.hpp"
#include "steady/regularised_profile.hpp"
#include "steady/uniform_flow.hpp"

/// Columns made by hand and run, for the tests that hold them against solutions found otherwise.
namespace talus::tests {

inline constexpr double degree = std::numbers::pi / 180.0;

/// Table 2 of the paper (rho_star from table 1) with any law of its parameters; unregularised; at rest; `slope` [degree].
inline column::Parameters table_2(double slope, double thickness, int layers, double mu_w = 0.3727) {
  const auto base = rheology::classical(0.4, 0.9, 1.3);
  return {.box = {.length = 1.0, .height = 1.0, .tilt = slope * degree, .gap = 0.003, .gravity = 9.81},
          .motion = {},
          .grains = rheology::grains(2500.0, 0.6, 0.00073),
          .law = rheology::partially_regularised(base, 1.3, 1.9, 0.05178),
          .regularisation = {},
          .wall = {.mu_w = mu_w, .u_c = 1e-3},
          .grid = {layers, grid::Spacing::uniform, 0.01},
          .thickness = thickness,
          .start = {},
          .atol_velocity = 1e-9};
}

inline steady::RegularisedLayer steady_layer(const column::Parameters& par) {
  return {{par.grains, par.law, par.box.gap, par.wall.mu_w, par.box.gravity},
          par.regularisation,
          par.wall.u_c,
          par.thickness};
}

/// The steady profile of rung 0 at the column's own regularisations, as a start.
inline experiment::PiecewiseLinear steady_start(const column::Parameters& par, double slope) {
  const auto profile = steady::RegularisedProfile::at(steady_layer(par), slope * degree);
  if (!profile) throw std::runtime_error(profile.reason());
  experiment::PiecewiseLinear start{{}, {profile->speeds().begin(), profile->speeds().end()}};
  for (const double z : profile->z()) start.at.push_back(-z);
  return start;
}

/// A column and its integrator, begun at t = 0.
class ColumnRun {
 public:
  ColumnRun(column::Parameters parameters, const ida::Options& options)
      : column_(std::move(parameters)), integrator_(column_, options) {
    std::vector<double> y(column_.layout().size()), yp(y);
    column_.initial_state(0.0, y, yp);
    integrator_.start(0.0, y, yp);
  }

  [[nodiscard]] const column::Column& column() const { return column_; }
  /// u [m/s] in the layers at time t [s].
  std::span<const double> at(double t) {
    if (t > integrator_.current().t) integrator_.advance(t, nobody_);
    return u();
  }
  [[nodiscard]] std::span<const double> u() const { return integrator_.current().y; }
  [[nodiscard]] const core::Statistics& statistics() const { return integrator_.current().statistics; }
  [[nodiscard]] double surface_speed() const { return column::surface_speed(column_, u()); }
  /// int u dz [m2/s].
  [[nodiscard]] double flow() const {
    double sum = 0.0;
    for (int k = 0; k < column_.heights().n_layers(); ++k) sum += u()[k] * column_.heights().thickness(k);
    return sum;
  }
  /// u [m/s] at a depth [m]: cubic in its square root, in which u is smooth under the surface.
  [[nodiscard]] double speed(double depth) const {
    if (depth == 0.0) return surface_speed();
    const auto& at = column_.heights();
    const int n = at.n_layers();
    const auto root = [&](int k) { return std::sqrt(at.surface() - at.centre[k]); };
    const auto above = std::ranges::upper_bound(at.centre, at.surface() - depth) - at.centre.begin();
    const int first = std::clamp(static_cast<int>(above) - 2, 0, n - 4);
    double sum = 0.0;
    for (int i = first; i < first + 4; ++i) {
      double weight = 1.0;
      for (int j = first; j < first + 4; ++j)
        if (j != i) weight *= (std::sqrt(depth) - root(j)) / (root(i) - root(j));
      sum += weight * u()[i];
    }
    return sum;
  }

 private:
  column::Column column_;
  ida::Ida integrator_;
  core::Observer nobody_;
};

/// IDA with an error far below what the tests look for.
inline ida::Options precise(double rtol = 1e-8) {
  ida::Options options;
  options.rtol = rtol;
  options.linear.choice = linear::Choice::banded;
  return options;
}

}  // namespace talus::tests
