#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "diagnostics/norms.hpp"
#include "ida/ida.hpp"
#include "layer/layer.hpp"

namespace talus::tests {

/// A flow known in closed form, at x, z [m] and t [s].
struct PointFlow {
  double u, w, p;  ///< [m/s], [m/s], [Pa]
};
using ExactFlow = std::function<PointFlow(double x, double z, double t)>;

/// Sets y (shape n) to the flow at t, on the grid that belongs to the thicknesses in y. The slopes that turn w into omega are
/// the grid's own.
inline void set_flow(const layer::Layer& system, const ExactFlow& flow, double t, std::span<double> y) {
  const auto& c = system.columns();
  const auto& at = system.unknowns();
  const auto& context = system.context(t, y);
  const auto z = [&](int i, int k) { return context.z[context.at(i, k)]; };
  for (int f = 0; f <= c.n_columns; ++f) {
    for (int k = 0; k < c.n_layers; ++k) {
      const double middle = 0.25 * (z(f - 1, k) + z(f, k) + z(f - 1, k + 1) + z(f, k + 1));
      if (at.u(f, k) >= 0) y[at.u(f, k)] = flow(c.x_face(f), middle, t).u;
    }
  }
  for (int i = 0; i < c.n_columns; ++i) {
    for (int k = 0; k < c.n_layers; ++k) {
      y[at.p(i, k)] = flow(c.x_centre(i), 0.5 * (z(i, k) + z(i, k + 1)), t).p;
      if (at.omega(i, k + 1) < 0) continue;
      const auto here = flow(c.x_centre(i), z(i, k + 1), t);
      const double slope = (z(i + 1, k + 1) - z(i - 1, k + 1)) / (2.0 * c.dx());
      y[at.omega(i, k + 1)] = here.w - here.u * slope;
    }
  }
}

/// Errors of a state against a flow, at the places of the grid as it stands: u at faces, w = omega + u slope on interfaces with u of
/// the flow, p in cells.
struct FlowErrors {
  diagnostics::Norms u, w, p;
};

/// With `level_free` the mean difference of p does not count.
inline FlowErrors errors(const layer::Layer& system, const ExactFlow& flow, double t, std::span<const double> y,
                         bool level_free = false) {
  const auto& c = system.columns();
  const auto& at = system.unknowns();
  const auto& context = system.context(t, y);
  const auto z = [&](int i, int k) { return context.z[context.at(i, k)]; };
  const auto slope = [&](int i, int k) { return (z(i + 1, k) - z(i - 1, k)) / (2.0 * c.dx()); };
  std::vector<double> u, w, p, volume_u, volume_w, volume_p;
  for (int f = 0; f <= c.n_columns; ++f) {
    for (int k = 0; k < c.n_layers; ++k) {
      if (at.u(f, k) < 0 || (c.periodic && f == c.n_columns)) continue;
      const double foot = 0.5 * (z(f - 1, k) + z(f, k)), top = 0.5 * (z(f - 1, k + 1) + z(f, k + 1));
      u.push_back(y[at.u(f, k)] - flow(c.x_face(f), 0.5 * (foot + top), t).u);
      volume_u.push_back(top - foot);
    }
  }
  for (int i = 0; i < c.n_columns; ++i) {
    for (int k = 0; k < c.n_layers; ++k) {
      p.push_back(y[at.p(i, k)] - flow(c.x_centre(i), 0.5 * (z(i, k) + z(i, k + 1)), t).p);
      volume_p.push_back(z(i, k + 1) - z(i, k));
      if (at.omega(i, k + 1) < 0) continue;
      const auto here = flow(c.x_centre(i), z(i, k + 1), t);
      w.push_back(y[at.omega(i, k + 1)] - (here.w - here.u * slope(i, k + 1)));
      volume_w.push_back(k + 2 <= c.n_layers ? 0.5 * (z(i, k + 2) - z(i, k)) : 0.5 * (z(i, k + 1) - z(i, k)));
    }
  }
  if (level_free) {
    double sum = 0.0, volume = 0.0;
    for (std::size_t j = 0; j < p.size(); ++j) sum += volume_p[j] * p[j], volume += volume_p[j];
    for (double& e : p) e -= sum / volume;
  }
  return {diagnostics::norms(u, volume_u), diagnostics::norms(w, volume_w), diagnostics::norms(p, volume_p)};
}

/// Carries y (shape n) from t_0 to t_1 [s], at a relative tolerance `rtol`.
inline void integrate(const layer::Layer& system, double t_0, double t_1, std::vector<double>& y, double rtol,
                      const ida::NewtonOptions& newton = {}) {
  ida::Options options;
  options.rtol = rtol;
  options.newton = newton;
  ida::Ida integrator(system, options);
  core::Observer nobody;
  const std::vector<double> rest(y.size(), 0.0);
  integrator.start(t_0, y, rest);
  integrator.advance(t_1, nobody);
  std::ranges::copy(integrator.current().y, y.begin());
}

/// At rest with the thickness of the start.
inline std::vector<double> state_at_rest(const layer::Layer& system) {
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  return y;
}

}  // namespace talus::tests
