#pragma once

#include <cmath>

#include "core/scalar.hpp"
#include "experiment/inflow.hpp"
#include "grid/columns.hpp"
#include "layer/parameters.hpp"

namespace talus::layer {

/// Share of the jet that lands left of the point x [m] on a surface at height H [m]: a normal distribution of standard deviation
/// sigma about the straight line on which grains fall along gravity from the inlet at (position, box.height). The paper's jet,
/// 0.02 m wide at the inlet, spreads little over its fall of 0.15 to 0.3 m: sigma of 6 mm is a slot of that width.
template <class S>
S jet_share_left_of(const Parameters& par, double x, const S& H) {
  using std::erf;
  using core::erf;
  const Inflow& inflow = par.inflow;
  const double drift = inflow.along_gravity ? std::tan(par.box.tilt) : 0.0;
  const S centre = inflow.position + drift * (par.box.height - H);
  return 0.5 + 0.5 * erf((x - centre) / (std::sqrt(2.0) * inflow.width));
}

/// Mean rate of rise of the surface of column i by the grains that land on it [m/s], for heights H at its two faces. Over all
/// columns the rates add up to the inflow exactly: what falls beyond an end is laid on the column at that end.
template <class S>
S jet_rate(const Parameters& par, const grid::Columns& columns, int i, const S& H_left, const S& H_right, double t) {
  const double flux = experiment::inflow_rate(par.inflow, t) / (par.grains.rho() * par.box.gap);
  const S left = i == 0 ? S(0.0) : jet_share_left_of(par, columns.x_face(i), H_left);
  const S right = i == columns.n_columns - 1 ? S(1.0) : jet_share_left_of(par, columns.x_face(i + 1), H_right);
  return flux / columns.dx() * (right - left);
}

}  // namespace talus::layer
