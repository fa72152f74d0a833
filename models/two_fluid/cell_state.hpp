#pragma once

#include <span>

#include "two_fluid/two_fluid.hpp"

namespace talus::two_fluid {

/// Everything pointwise in the middle of a cell, from the same strain rates and viscosity as the equations. Where grains do not fill half
/// the cell, I, mu, C and q are not numbers; where there is no cell, nothing is.
struct CellState {
  double u, w;         ///< [m/s]
  double phi;          ///< [1]
  double p;            ///< [Pa]
  double D_norm;       ///< [1/s]
  double I, mu;        ///< [1]; as regularised
  double eta;          ///< of the grains [Pa s]
  double eta_mixture;  ///< [Pa s]
  bool capped;         ///< the viscosity cap takes away more than half, in a cell of grains
  double C, q;         ///< (3.18) and mu - I mu'/2
};

/// From here on a cell counts as one of grains [1].
inline constexpr double dense = 0.5;

/// `context` is that of the system at the time of y.
CellState cell_state(const TwoFluid& system, const Context& context, std::span<const double> y, int i, int k);

/// Height of the grains on the base of column i [m]: what lies in cells from the base up to the first that is not dense, of which its
/// grains count, too. Grains in the air above do not.
double heap_height(const TwoFluid& system, std::span<const double> y, int i);

}  // namespace talus::two_fluid
