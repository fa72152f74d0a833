#pragma once

#include <cstdint>

#include "rheology/well_posedness.hpp"

namespace talus::symbol {

/// Where a staggered grid takes the viscosity that acts on the shear stress, which lives at corners.
enum class CornerViscosity : std::uint8_t {
  direct,   ///< from strain rate and pressure at the corner itself
  averaged  ///< the mean of four cells, each from the mean shear of its four corners: the common choice
};

/// Growth rate over eta/(rho h^2) of the one mode without divergence of a plane wave about uniform shear, on the textbook staggered grid of
/// square cells h (u and w on faces, p in cells, central differences), in closed form. `phase_x`, `phase_z`: k_x h and k_z h [rad], not
/// both 0. For long waves rheology::growth times (k h)^2.
///
/// With c = cos(phase_x/2) cos(phase_z/2) a mean over four neighbours, the linear shear stress is 2 eta [1 - (1 - nu) c^2] D + q c p when
/// averaged and 2 eta nu D + q c p when direct: averages turn the shortest waves into those of a Newtonian fluid.
[[nodiscard]] double staggered_growth(const rheology::Response& response, CornerViscosity viscosity, double phase_x,
                                      double phase_z);

}  // namespace talus::symbol
