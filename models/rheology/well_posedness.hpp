#pragma once

#include <optional>
#include <vector>

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

/// eta k^2/rho over the shear rate gamma: mu (k d)^2/(Phi I^2), at wave number k [1/m].
[[nodiscard]] double growth_scale(const Grains& grains, const Response& r, double I, double k);

/// All I in [1e-12, 1e6] at which C (3.18) of the law changes sign, ascending, exact to rounding; a jump across zero at
/// I_N counts. Pairs of points closer than 2 % are not resolved.
[[nodiscard]] std::vector<double> neutral_points(const Law& law);

/// The smallest I in that range with q = 1, the true bound of the linear theory for laws with nu > 1/2 there.
[[nodiscard]] std::optional<double> ellipticity_bound(const Law& law);

}  // namespace talus::rheology
