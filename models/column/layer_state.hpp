#pragma once

#include <span>
#include <vector>

#include "column/column.hpp"
#include "diagnostics/flow_class.hpp"

namespace talus::column {

/// Everything pointwise in the middle of a layer, from the same shear rates and viscosity as the equation.
struct LayerState {
  double u;           ///< down the slope [m/s]
  double p;           ///< [Pa]
  double D_norm;      ///< [1/s]
  double I, mu, eta;  ///< [1], [1], [Pa s]; as regularised
  double C, nu,
      q;  ///< (3.18), I mu'/mu and mu - I mu'/2: well-posed where C <= 0, by linear theory where nu > 1/2 and q < 1 too
  double growth_per_k2;  ///< diagnostics::growth_per_square [m2/s]
  diagnostics::FlowClass flow_class;
  bool capped;               ///< the viscosity cap takes away more than half
  bool floored;              ///< the floor under the strain rate is above the strain rate
  double pressure_shift;     ///< what p_0 adds, p_+ - p [Pa]
  double wall_mobilisation;  ///< tanh(|u|/u_c), the share of wall friction that is turned on [1]
};

/// From the base up, shape n_layers.
std::vector<LayerState> layer_states(const Column& column, double t, std::span<const double> u);

/// u [m/s] on the surface itself, half a layer above the uppermost unknown: with du/dz as the root of the depth times a
/// linear function, for under a free surface I varies slowly.
double surface_speed(const Column& column, std::span<const double> u);

/// What acts on the column, a unit area of the base [Pa], positive down the slope.
struct Forces {
  double weight, wall_friction, base_stress;
  double momentum_rate;  ///< d/dt int rho u dz, summed over the layers' own balances

  /// Zero to rounding where the stresses between the layers cancel.
  [[nodiscard]] double imbalance() const { return weight + wall_friction + base_stress - momentum_rate; }
};

Forces forces(const Column& column, double t, std::span<const double> u);

}  // namespace talus::column
