#pragma once

#include <string>
#include <vector>

#include "steady/sensitivity.hpp"

namespace talus::fit {

/// A product of powers of parameters through which alone some of them act.
struct Lump {
  std::string name, formula, unit;
  steady::Gradient power;  ///< of each parameter
  double factor;           ///< of what is not a parameter, a power of g
};

/// Candidates, the simplest first: (4.8), (4.12) and (4.13) contain mu_w, W, d, Phi, rho_star only as mu_w/W,
/// sqrt(Phi g)/d and rho W; the flux only as one product of them; I_0, where no other scale of I is fixed, only times these.
[[nodiscard]] std::vector<Lump> lumps(const steady::VariedChannel& varied);
[[nodiscard]] double value_of(const Lump& lump, const steady::Gradient& parameters);

}  // namespace talus::fit
