#pragma once

#include <cmath>

#include "core/scalar.hpp"

namespace talus::rheology {

/// tanh(sqrt(x)/u_c)/sqrt(x) for x = |u|^2 >= 0: the factor that turns u into the direction of wall friction.
/// Smooth at rest.
template <class S>
S friction_direction(const S& speed_squared, double u_c) {
  using std::sqrt;
  using std::tanh;
  using core::sqrt;
  using core::tanh;
  const S s = speed_squared / (u_c * u_c);
  return core::select_above(
      s, 1e-6,
      [&] {
        const S root = sqrt(s);
        return S(tanh(root) / (u_c * root));
      },
      [&] { return S((1.0 - s / 3.0) / u_c); });
}

}  // namespace talus::rheology
