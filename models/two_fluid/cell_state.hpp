#pragma once

#include <span>

#include "diagnostics/flow_class.hpp"
#include "two_fluid/two_fluid.hpp"

namespace talus::two_fluid {

/// Everything pointwise in the middle of a cell, from the same strain rates and viscosity as the equations. Where grains do not fill half
/// the cell, I, mu, C, nu, q and growth_per_k2 are not numbers; where there is no cell, nothing is.
struct CellState {
  double u, w;                        ///< [m/s]
  double phi;                         ///< [1]
  double p;                           ///< [Pa]
  double D_norm;                      ///< [1/s]
  double I, mu;                       ///< [1]; as regularised
  double eta;                         ///< of the grains [Pa s]
  double eta_mixture;                 ///< [Pa s]
  bool capped;                        ///< the viscosity cap takes away more than half, in a cell of grains
  double C, nu, q;                    ///< (3.18), I mu'/mu and mu - I mu'/2
  double growth_per_k2;               ///< diagnostics::growth_per_square, of grains alone [m2/s]
  diagnostics::FlowClass flow_class;  ///< means nothing where grains do not fill half the cell
};

/// From here on a cell counts as one of grains [1].
inline constexpr double dense = 0.5;

/// `context` is that of the system at the time of y.
CellState cell_state(const TwoFluid& system, const Context& context, std::span<const double> y, int i, int k);

/// Height of the grains on the base of column i [m]: what lies in cells from the base up to the first that is not dense, of which its
/// grains count, too. Grains in the air above do not.
double heap_height(const TwoFluid& system, std::span<const double> y, int i);

}  // namespace talus::two_fluid
