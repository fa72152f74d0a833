#pragma once

namespace talus::rheology {

/// A fluid of constant viscosity: no grains, but what the exact solutions of viscous flow are known for.
struct Newtonian {
  double eta;  ///< [Pa s]
};

}  // namespace talus::rheology
