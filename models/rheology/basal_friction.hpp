#pragma once

#include <cmath>

#include "core/scalar.hpp"

namespace talus::rheology {

/// Shear stress [Pa] that a base of limited friction passes on: tau, that of grains which stick to it, as long as it is small against
/// `limit` = mu_b p > 0, and never more than that: tau/(1 + (tau/limit)^4)^(1/4). The grains slide by what is missing.
template <class S>
S limited_shear(const S& tau, const S& limit) {
  using std::sqrt;
  using core::sqrt;
  const S share = tau / limit, squared = share * share;
  return tau / sqrt(S(sqrt(S(1.0 + squared * squared))));
}

}  // namespace talus::rheology
