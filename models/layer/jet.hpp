#pragma once

#include <cmath>

#include "core/scalar.hpp"
#include "grid/columns.hpp"
#include "layer/parameters.hpp"

namespace talus::layer {

/// Share of the full inflow at time t [s]: 0 before `start`, a C2 quintic ramp up, 1, a ramp down that begins at `stop`.
inline double jet_schedule(const Inflow& inflow, double t) {
  const auto ramp = [&](double since) {
    const double s = inflow.ramp > 0.0 ? since / inflow.ramp : (since > 0.0 ? 1.0 : 0.0);
    if (s <= 0.0) return 0.0;
    if (s >= 1.0) return 1.0;
    return s * s * s * (10.0 + s * (6.0 * s - 15.0));
  };
  return ramp(t - inflow.start) - ramp(t - inflow.stop);
}

/// Mean rate of rise of the surface of column i by the grains that land on it [m/s]: the inflow Q/(rho W) spread along x as
/// a normal distribution of width sigma about the place where a jet that falls along gravity from the inlet, at height
/// `box.height`, meets the surface H. The jet of the paper falls 0.15-0.3 m and spreads; its line is straight, as gravity is.
template <class S>
S jet_rate(const Parameters& par, const grid::Columns& columns, int i, const S& H, double t) {
  using std::erf;
  using core::erf;
  const Inflow& inflow = par.inflow;
  const double flux = inflow.rate * jet_schedule(inflow, t) / (par.grains.rho() * par.box.gap);
  const double drift = inflow.along_gravity ? std::tan(par.box.tilt) : 0.0;
  const S centre = inflow.position + drift * (par.box.height - H);
  const double scale = 1.0 / (std::sqrt(2.0) * inflow.width);
  const S share = 0.5 * (erf((columns.x_face(i + 1) - centre) * scale) - erf((columns.x_face(i) - centre) * scale));
  return flux / columns.dx() * share;
}

}  // namespace talus::layer
