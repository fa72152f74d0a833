#pragma once

#include "steady/uniform_flow.hpp"

namespace talus::steady {

/// Averages of a flow over its depth down to the base, where one bounds the flow; else down to where the speed is 1 % of
/// that at the surface, for the creep below has no lower end that could be seen.
struct LayerMean {
  static constexpr double share = 0.01;
  bool to_base;   ///< which of the two depths it is
  double depth;   ///< [m]
  double speed;   ///< [m/s]
  double froude;  ///< speed/sqrt(g depth cos zeta)
};

[[nodiscard]] LayerMean layer_mean(const UniformFlow& flow);

}  // namespace talus::steady
