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

}  // namespace talus::tests
