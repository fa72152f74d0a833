#pragma once

#include <cmath>

#include "core/scalar.hpp"

namespace talus::rheology {

/// Shear stress [Pa] that a base of limited friction passes on: tau, that of grains which stick to it, as long as its share of what the
/// base can hold, `share` = tau/(mu_b p), is small; and never more than that: tau/(1 + share^4)^(1/4). The grains slide by what is missing.
template <class S>
S limited_shear(const S& tau, const S& share) {
  using std::sqrt;
  using core::sqrt;
  const S squared = share * share;
  return tau / sqrt(S(sqrt(S(1.0 + squared * squared))));
}

}  // namespace talus::rheology
