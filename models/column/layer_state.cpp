#include "column/layer_state.hpp"

#include <cmath>

#include "column/terms/momentum.hpp"
#include "rheology/well_posedness.hpp"

namespace talus::column {
namespace {

double shear_rate(const Column& column, std::span<const double> u, int k) {
  const auto& at = column.heights();
  const double below = k > 0 ? u[k - 1] : 0.0;
  return (u[k] - speed_below(at, column.parameters().box.base_slip_length, k, below, u[k])) / at.distance(k);
}

/// Under a free surface du/dz goes as the root of the depth: divided by it, it is smooth, and taken as linear between
/// interfaces and beyond the last.
double divided_shear(const Column& column, std::span<const double> u, int k) {
  const auto& at = column.heights();
  return shear_rate(column, u, k) / std::sqrt(at.surface() - at.interface[k]);
}

/// Its change with depth in the top layer [m^-3/2 s^-1].
double divided_shear_slope(const Column& column, std::span<const double> u) {
  const auto& at = column.heights();
  const int top = at.n_layers() - 1;
  return (divided_shear(column, u, top - 1) - divided_shear(column, u, top)) / at.thickness(top - 1);
}

/// du/dz in the middles of the layers.
std::vector<double> shear_in_the_middle(const Column& column, std::span<const double> u) {
  const auto& at = column.heights();
  std::vector<double> shear;
  const int top = at.n_layers() - 1;
  for (int k = 0; k <= top; ++k) {
    const double here = k < top ? 0.5 * (divided_shear(column, u, k) + divided_shear(column, u, k + 1))
                                : divided_shear(column, u, k) - divided_shear_slope(column, u) * 0.5 * at.thickness(k);
    shear.push_back(here * std::sqrt(at.surface() - at.centre[k]));
  }
  return shear;
}

}  // namespace

std::vector<LayerState> layer_states(const Column& column, double t, std::span<const double> u) {
  const auto& par = column.parameters();
  const auto& at = column.heights();
  const auto c = column.context(t);
  const auto shear = shear_in_the_middle(column, u);
  std::vector<LayerState> states;
  for (int k = 0; k < at.n_layers(); ++k) {
    LayerState s{};
    const double D_squared = 0.25 * shear[k] * shear[k];
    s.u = u[k];
    s.p = c.pressure(at.centre[k]);
    s.D_norm = std::sqrt(D_squared);
    s.I = rheology::inertial_number(par.grains, par.regularisation, D_squared, c.rate_floor, s.p);
    const auto response = rheology::response(par.law, s.I);
    s.mu = response.mu;
    s.C = rheology::condition_C(response);
    s.nu = response.nu;
    s.q = response.q;
    s.eta = shear_viscosity(c, shear[k], s.p);
    s.capped = rheology::is_capped(par.law, par.grains, par.regularisation, D_squared, c.rate_floor, s.p);
    s.growth_per_k2 = diagnostics::growth_per_square(response, s.capped, s.eta, par.grains.rho());
    s.flow_class = diagnostics::flow_class(response, s.capped);
    s.floored = c.rate_floor > s.D_norm;
    s.pressure_shift = rheology::positive_pressure(s.p, par.regularisation.p_0) - s.p;
    s.wall_mobilisation = std::abs(u[k] * rheology::friction_direction(u[k] * u[k], par.wall.u_c));
    states.push_back(s);
  }
  return states;
}

double surface_speed(const Column& column, std::span<const double> u) {
  const auto& at = column.heights();
  const int top = at.n_layers() - 1;
  const double half = 0.5 * at.thickness(top), slope = divided_shear_slope(column, u);
  const double on_surface = divided_shear(column, u, top) - slope * at.thickness(top);
  // The integral of (on_surface + slope s) sqrt(s) over the depth s of the upper half of the layer.
  return u[top] + half * std::sqrt(half) * (on_surface / 1.5 + slope * half / 2.5);
}

Forces forces(const Column& column, double t, std::span<const double> u) {
  const auto& at = column.heights();
  const auto c = column.context(t);
  Forces f{};
  const double on_base = shear_rate(column, u, 0);
  f.base_stress = -base_stress(c, on_base);
  std::vector<double> at_rest(u.size(), 0.0), rates(u.size());
  column.residual(t, u, at_rest, rates);
  for (int k = 0; k < at.n_layers(); ++k) {
    f.weight += c.weight * at.thickness(k);
    f.wall_friction -= at.thickness(k) * wall_drag(c, at.centre[k], u[k]);
    f.momentum_rate -= rates[k];
  }
  return f;
}

}  // namespace talus::column
