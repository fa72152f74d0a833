#pragma once

#include "steady/channel.hpp"

namespace talus::triangle {

/// Q [kg/s] that flows down a face, and how it changes with the face.
struct Outflow {
  double rate;          ///< [kg/s]
  double by_tangent;    ///< dQ/d(tan zeta) [kg/s]
  double by_thickness;  ///< dQ/dh [kg/s/m]
};

/// The exact steady flow (section 4) on a face of tangent `tan_zeta` > 0 over a base `thickness` [m] >= 0 below it; nothing
/// where the face is not steeper than friction at rest. Derivatives are exact: with s the depth below the surface,
/// Q = rho W int s (du/dz) ds, and the friction at a depth depends on tan zeta - mu_w s/W alone.
/// Throws core::InadmissibleState where no steady flow is that steep.
[[nodiscard]] Outflow outflow(const steady::Channel& channel, double tan_zeta, double thickness);

}  // namespace talus::triangle
