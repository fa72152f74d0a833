#include "layer/cell_state.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostics/flow_class.hpp"
#include "layer/bounds.hpp"
#include "layer/terms/stress.hpp"
#include "rheology/well_posedness.hpp"

namespace talus::layer {
namespace {

using fv::read;

double slope_at(const Layer& layer, const Context& c, int i, int k) {
  return (c.z[c.at(i + 1, k)] - c.z[c.at(i - 1, k)]) / (2.0 * layer.columns().dx()) + layer.parameters().box.base_slope;
}

/// I at interface k < n_layers of face f, where the shear across layers is one compact difference.
double corner_inertial_number(const Layer& layer, const Context& c, std::span<const double> y, int f, int k) {
  std::array<Index, CornerSlots::n_in> in{};
  CornerSlots::connect(layer.unknowns(), f, k, in);
  fv::Inputs<double, CornerSlots::n_in> inputs{};
  for (int j = 0; j < CornerSlots::n_in; ++j) inputs.y[j] = read(y, in[j]);
  const Heights<double, CornerSlots::n_in> g(c, f - 2, inputs, CornerSlots::H_);
  const bool slips = layer.parameters().box.base == Contact::free_slip;
  const auto base = k == 0 && !slips ? std::optional(base_contact(c, f)) : std::nullopt;
  const auto strain = corner_strain(g, k, layer.columns().dx(), base, inputs.y);
  const auto& reg = layer.parameters().regularisation;
  const double floor = rheology::rate_floor(reg, 0.5 * (g.H(1) + g.H(2)));
  return rheology::inertial_number(layer.parameters().grains, reg,
                                   strain.D_xx * strain.D_xx + strain.D_xz * strain.D_xz, floor,
                                   corner_pressure(g, k, inputs.y));
}

/// I in the middle of cell (i, k): the mean of its corners'; in the top layer, on from the two interfaces below.
double mean_inertial_number(const Layer& layer, const Context& c, std::span<const double> y, int i, int k) {
  const auto at = [&](int interface) {
    return 0.5 *
           (corner_inertial_number(layer, c, y, i, interface) + corner_inertial_number(layer, c, y, i + 1, interface));
  };
  const double below =
      at(k == 0 && layer.parameters().box.base_friction ? 1 : k);  // shear on a base that slides is not known
  if (k + 1 < layer.columns().n_layers) return 0.5 * (below + at(k + 1));
  const double h = c.z[c.at(i, k + 1)] - c.z[c.at(i, k)], h_below = c.z[c.at(i, k)] - c.z[c.at(i, k - 1)];
  return std::max(below + (below - at(k - 1)) * 0.5 * h / h_below, 0.0);
}

}  // namespace

CellState cell_state(const Layer& layer, const Context& c, std::span<const double> y, int i, int k) {
  const Parameters& par = layer.parameters();
  std::array<Index, CentreSlots::n_in> in{};
  CentreSlots::connect(layer.unknowns(), i, k, in);
  fv::Inputs<double, CentreSlots::n_in> inputs{};
  for (int j = 0; j < CentreSlots::n_in; ++j) inputs.y[j] = read(y, in[j]);
  const auto& v = inputs.y;
  const Heights<double, CentreSlots::n_in> g(c, i - 2, inputs, CentreSlots::H_);
  const auto strain = centre_strain(g, k, layer.columns().n_layers, layer.columns().dx(), bounds(c, i), v);
  const double D_squared = strain.D_xx * strain.D_xx + strain.D_xz * strain.D_xz;
  const auto& reg = par.regularisation;
  const double floor = rheology::rate_floor(reg, g.H(2));

  CellState s{};
  s.u = 0.5 * (v[1] + v[4]);
  s.w = s.u * g.slope_centre(2, k) + 0.5 * (v[CentreSlots::omega_ + 2] + v[CentreSlots::omega_ + 3]);
  s.p = v[CentreSlots::p_];
  s.D_norm = std::sqrt(D_squared);
  s.I = mean_inertial_number(layer, c, y, i, k);
  const auto response = rheology::response(par.law, s.I);
  s.mu = response.mu;
  s.C = rheology::condition_C(response);
  s.nu = response.nu;
  s.q = response.q;
  s.eta = par.fluid ? par.fluid->eta : rheology::viscosity(par.law, par.grains, reg, D_squared, floor, s.p);
  s.capped = rheology::is_capped(par.law, par.grains, reg, D_squared, floor, s.p);
  s.growth_per_k2 = diagnostics::growth_per_square(response, s.capped, s.eta, par.grains.rho());
  return s;
}

double vertical_velocity(const Layer& layer, const Context& c, std::span<const double> y, int i, int k) {
  const auto& at = layer.unknowns();
  const int n = layer.columns().n_layers;
  const auto u = [&](int layer_number) {
    return 0.5 * (read(y, at.u(i, layer_number)) + read(y, at.u(i + 1, layer_number)));
  };
  if (k == 0 && layer.parameters().box.base == Contact::no_slip) {
    const auto below = bounds(c, i);
    const double slope = slope_at(layer, c, i, 0), half = 0.5 * (c.z[c.at(i, 1)] - c.z[c.at(i, 0)]);
    const double share = base_slip_share(below.base_slip_length, c.mobility[i].value, slope, half);
    return (below.base_speed + share * (u(0) - below.base_speed)) * slope;
  }
  const double u_here = k == 0 ? u(0) : (k < n ? 0.5 * (u(k - 1) + u(k)) : u(n - 1));
  return read(y, at.omega(i, k)) + u_here * slope_at(layer, c, i, k);
}

}  // namespace talus::layer
