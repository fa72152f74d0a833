#pragma once

#include "rheology/law.hpp"

namespace talus::steady {

/// Grains flowing between two rough side walls.
struct Channel {
  rheology::Grains grains;
  rheology::Law law;
  double gap;      ///< W [m]
  double mu_w;     ///< side-wall friction [1]; 0: none
  double gravity;  ///< g [m/s2]
};

/// Throws std::invalid_argument naming what is not finite or out of range.
void check(const Channel& channel);
/// Throws std::invalid_argument unless 0 < zeta < pi/2 and 0 < thickness, which must be finite where no wall bounds the
/// flow.
void check_layer(const Channel& channel, double zeta, double thickness);

}  // namespace talus::steady
