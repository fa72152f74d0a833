#pragma once

#include <span>

#include "layer/layer.hpp"

namespace talus::layer {

/// Everything pointwise in the middle of cell (i, k), from the same strain rates and viscosity as the equations; I, and mu, C
/// and q with it, is the mean of the corners', where the shear is resolved best.
struct CellState {
  double u, w;        ///< [m/s]
  double p;           ///< [Pa]
  double D_norm;      ///< [1/s]
  double I, mu, eta;  ///< [1], [1], [Pa s]; as regularised
  bool capped;        ///< the viscosity cap takes away more than half
  double C, nu,
      q;  ///< (3.18), I mu'/mu and mu - I mu'/2: well-posed where C <= 0, by linear theory where nu > 1/2 and q < 1 too
  double growth_per_k2;  ///< diagnostics::growth_per_square [m2/s]
};

/// `context` must be that of `y`.
CellState cell_state(const Layer& layer, const Context& context, std::span<const double> y, int i, int k);

/// Vertical velocity w [m/s] on interface k of column i.
double vertical_velocity(const Layer& layer, const Context& context, std::span<const double> y, int i, int k);

}  // namespace talus::layer
