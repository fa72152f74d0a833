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

/// Navier's slip on a base that stands still, u_b = l du/dz: the share u_b/u of the speed u at `distance` above the base, with one
/// shear rate in between, for a slip length l >= 0 in the distance's unit.
template <class Length, class Distance>
auto slip_share(const Length& slip_length, const Distance& distance) {
  return slip_length / (distance + slip_length);
}

}  // namespace talus::rheology
