#include "layer/cell_state.hpp"

#include <cmath>

#include "layer/terms/stress.hpp"
#include "rheology/well_posedness.hpp"

namespace talus::layer {
namespace {

double read(std::span<const double> y, Index index) { return index < 0 ? 0.0 : y[index]; }

double slope_at(const Layer& layer, const Context& c, int i, int k) {
  return (c.z[c.at(i + 1, k)] - c.z[c.at(i - 1, k)]) / (2.0 * layer.columns().dx()) + layer.parameters().box.base_slope;
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
  const auto strain = centre_strain(g, k, layer.columns().n_layers, layer.columns().dx(), v);
  const double D_squared = strain.D_xx * strain.D_xx + strain.D_xz * strain.D_xz;
  const auto& reg = par.regularisation;
  const double floor = std::hypot(reg.rate_floor, reg.rate_speed / g.H(2));

  CellState s{};
  s.u = 0.5 * (v[1] + v[4]);
  s.w = s.u * g.slope_centre(2, k) + 0.5 * (v[CentreSlots::omega_ + 2] + v[CentreSlots::omega_ + 3]);
  s.p = v[CentreSlots::p_];
  s.D_norm = std::sqrt(D_squared);
  s.I = rheology::inertial_number(par.grains, reg, D_squared, floor, s.p);
  const auto response = rheology::response(par.law, s.I);
  s.mu = response.mu;
  s.C = rheology::condition_C(response);
  s.q = response.q;
  s.eta = rheology::viscosity(par.law, par.grains, reg, D_squared, floor, s.p);
  auto uncapped = reg;
  uncapped.cap = rheology::Cap::none;
  s.capped = reg.cap != rheology::Cap::none &&
             s.eta < 0.5 * rheology::viscosity(par.law, par.grains, uncapped, D_squared, floor, s.p);
  return s;
}

double vertical_velocity(const Layer& layer, const Context& c, std::span<const double> y, int i, int k) {
  if (k == 0) return 0.0;
  const auto& at = layer.unknowns();
  const int n = layer.columns().n_layers;
  const auto u = [&](int layer_number) { return 0.5 * (read(y, at.u(i, layer_number)) + read(y, at.u(i + 1, layer_number))); };
  const double u_here = k < n ? 0.5 * (u(k - 1) + u(k)) : u(n - 1);
  return read(y, at.omega(i, k)) + u_here * slope_at(layer, c, i, k);
}

}  // namespace talus::layer
