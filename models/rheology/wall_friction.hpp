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

/// Weight of the pressure behind in the mean that friction of side walls acts on between two places, 1/K - 1/(e^K - 1): with it
/// p_behind - p_ahead = K (weight p_behind + (1 - weight) p_ahead) is Janssen's p_behind = p_ahead e^K exactly. K is the drag over the
/// distance of the places a unit pressure [1], positive against motion ahead. One half for small K; never so much that p_behind has no part
/// left, K weight < 1, which plain means reach at K = 2: a pole of the pressure.
template <class S>
S weight_behind(const S& K) {
  using std::exp;
  using core::exp;
  constexpr double small = 0.02;
  const auto fitted = [](const S& k) {  // k > 0
    const S rest = exp(S(-k));
    return S(1.0 / k - rest / (1.0 - rest));
  };
  return core::select_above(
      K, small, [&] { return fitted(K); },
      [&] {
        return core::select_above(
            S(-K), small, [&] { return S(1.0 - fitted(S(-K))); },
            [&] { return S(0.5 - K * (1.0 / 12.0 - K * K / 720.0)); });
      });
}

}  // namespace talus::rheology
