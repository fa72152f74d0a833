#pragma once

#include "layer/layer.hpp"

/// Small set-ups of the layer model for verification, built from the room's own parameters.
namespace talus::tests {

/// Table 2 of the paper (rho_* of table 1), with I_N where the slope of mu(I) is continuous enough for (3.18) to vanish.
inline rheology::Grains table_2_grains() { return rheology::grains(2500.0, 0.6, 0.00073); }
inline rheology::Classical table_2_classical() { return rheology::classical(0.4, 0.9, 1.3); }
inline rheology::PartiallyRegularised table_2_partial() {
  return rheology::partially_regularised(table_2_classical(), 1.3, 1.9);
}

/// A layer of `thickness` [m] in a box of `length` [m] tilted by `tilt` [rad], joined at its ends, without side walls, inflow
/// or any regularisation.
inline layer::Parameters periodic_layer(double length, double thickness, double tilt, int columns, int layers) {
  return {
      .box =
          {.length = length, .height = 10.0 * thickness, .tilt = tilt, .gap = 0.003, .gravity = 9.81, .periodic = true},
      .grains = table_2_grains(),
      .law = table_2_partial(),
      .regularisation = {},
      .wall = {.mu_w = 0.0, .u_c = 1e-3},
      .inflow = {},
      .grid = {.columns = columns, .layers = layers, .cluster_depth = 1e3 * thickness},
      .numerics = {},
      .initial = {thickness}};
}

/// A box of length and thickness 1 m full of a fluid of density 1 kg/m3 and viscosity `eta` [Pa s], without weight, under a lid to
/// which it sticks; joined at its ends, central advection, tolerances far below any error of the grid.
inline layer::Parameters fluid_box(double eta, int columns, int layers) {
  auto par = periodic_layer(1.0, 1.0, 0.0, columns, layers);
  par.box.gravity = 0.0;
  par.box.lid = experiment::Lid{};
  par.grains = rheology::grains(1.0, 1.0, 1e-3);
  par.fluid = rheology::Newtonian{eta};
  par.numerics = {.advection = layer::Advection::central, .film = 1e-6, .jump_from = 3.0, .jump_to = 4.0};
  par.atol_velocity = 1e-8;
  par.atol_pressure = 1e-7;
  par.atol_height = 1e-9;
  return par;
}

}  // namespace talus::tests
