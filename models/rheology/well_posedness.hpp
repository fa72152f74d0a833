#pragma once

#include "rheology/law.hpp"

namespace talus::rheology {

/// The three numbers of a law at one I that decide the linear stability of short waves on simple shear.
struct Response {
  double mu;  ///< friction
  double nu;  ///< I mu'/mu
  double q;   ///< mu (1 - nu/2) = mu - I mu'/2
};

[[nodiscard]] Response response(const Law& law, double I);

/// C of (3.18), written q^2 - 4 nu (1 - nu). Positive: ill-posed by the paper's criterion; for nu > 1/2 that is
/// conservative.
[[nodiscard]] double condition_C(const Response& r);

/// Frozen-coefficient growth rate over eta k^2/rho of a wave k = k (cos phi, sin phi), s = sin 2 phi in [-1, 1]:
/// -1 + (1 - nu)(1 - s^2)/(1 - q s). Has a pole inside [-1, 1] where |q| > 1.
[[nodiscard]] double growth(const Response& r, double s);

/// Largest growth over all directions, in units of eta k^2/rho: for q < 1, -1 + 2 max(1 - nu, 0)/(1 + sqrt(1 - q^2));
/// infinite for q >= 1, where the pressure equation is no longer elliptic. Positive: ill-posed.
[[nodiscard]] double max_growth(const Response& r);

/// s = sin 2 phi in [-1, 1] of the fastest wave, phi the angle of its wave vector against the flow, or 90 degrees less
/// that angle: q/(1 + sqrt(1 - q^2)); the pole 1/q of the growth where |q| >= 1; 1 (and -1 alike) where nu > 1.
[[nodiscard]] double worst_direction(const Response& r);

/// What becomes of short waves: damped, as the paper's C <= 0 says; damped although C > 0 (nu > 1/2 and q < 1); or
/// growing the faster the shorter they are, where the equations are ill-posed.
enum class WellPosedness { well_posed, damped, ill_posed };
[[nodiscard]] WellPosedness well_posedness(const Response& r);

/// eta k^2/rho over the shear rate gamma: mu (k d)^2/(Phi I^2), at wave number k [1/m].
[[nodiscard]] double growth_scale(const Grains& grains, const Response& r, double I, double k);

}  // namespace talus::rheology
