#pragma once

#include <cmath>
#include <limits>

#include "core/scalar.hpp"
#include "rheology/law.hpp"

namespace talus::rheology {

/// A rate [1/s] and a granular sound speed sqrt(p/rho_*) [m/s] below these count as these: sqrt stays differentiable. They are the
/// room's only numbers with a unit, and act on no bit of what lies above them.
inline constexpr double tiny_rate = 1e-12;
inline constexpr double tiny_speed = 1e-9;

/// Bounds of eta: none; hard: min(eta, eta_max) as (5.10), with a kink; smooth: eta/sqrt(1 + (eta/eta_max)^2), C1.
enum class Cap { none, hard, smooth };

/// Named regularisations of the granular viscosity; each is exact when switched off (zero, or `none`).
struct Regularisation {
  double p_0 = 0.0;  ///< positive-part pressure p_+ = (p + sqrt(p^2 + p_0^2))/2 [Pa]; 0: p_+ = max(p, 0), with a kink
  double rate_floor = 0.0;  ///< constant floor under D_norm [1/s]
  double rate_speed = 0.0;  ///< u_r: floor u_r / H under D_norm, H the local thickness [m/s]
  double eta_max = std::numeric_limits<double>::infinity();  ///< [Pa s]
  Cap cap = Cap::none;
};

/// Throws std::invalid_argument naming the parameter: all finite and >= 0, eta_max > 0 and finite where it caps.
void check(const Regularisation& reg);

/// The floor under D_norm [1/s] in a layer of thickness H [m], both floors together.
[[nodiscard]] inline double rate_floor(const Regularisation& reg, double H) {
  return std::hypot(reg.rate_floor, reg.rate_speed / H);
}

namespace detail {

/// sqrt(max(x, least^2)).
template <class S>
S root_at_least(const S& x, double least) {
  using std::sqrt;
  using core::sqrt;
  return core::select_above(
      x, least * least, [&] { return S(sqrt(x)); }, [&] { return S(least); });
}

}  // namespace detail

/// p_+ [Pa].
template <class S>
S positive_pressure(const S& p, double p_0) {
  using std::sqrt;
  using core::sqrt;
  if (!(p_0 > 0.0))
    return core::select_above(
        p, 0.0, [&] { return p; }, [] { return S(0.0); });
  const S root = sqrt(p * p + p_0 * p_0);
  // Below zero the plain form would cancel.
  return core::select_above(
      p, 0.0, [&] { return S(0.5 * (p + root)); }, [&] { return S((0.5 * p_0 * p_0) / (root - p)); });
}

/// I (3.15) with the same regularisations as the viscosity.
template <class S, class F>
S inertial_number(const Grains& grains, const Regularisation& reg, const S& D_norm_squared, const F& floor,
                  const S& p) {
  const S rate = detail::root_at_least(S(D_norm_squared + floor * floor), tiny_rate);
  return 2.0 * grains.d * rate / detail::root_at_least(S(positive_pressure(p, reg.p_0) / grains.rho_star), tiny_speed);
}

/// eta [Pa s] of (3.17), at D_norm^2 [1/s2] and pressure p [Pa]; `floor` [1/s] joins D_norm as sqrt(D_norm^2 +
/// floor^2), and the same floored rate enters I (3.15). Finite, with finite derivatives, at rest and at any p.
template <class S, class F>
S viscosity(const Law& law, const Grains& grains, const Regularisation& reg, const S& D_norm_squared, const F& floor,
            const S& p) {
  using std::sqrt;
  using core::sqrt;
  const S p_plus = positive_pressure(p, reg.p_0);
  const S rate = detail::root_at_least(S(D_norm_squared + floor * floor), tiny_rate);
  const S I = 2.0 * grains.d * rate / detail::root_at_least(S(p_plus / grains.rho_star), tiny_speed);
  const S eta = friction(law, I) * p_plus / (2.0 * rate);
  switch (reg.cap) {
    case Cap::none: return eta;
    case Cap::hard:
      return core::select_above(
          eta, reg.eta_max, [&] { return S(reg.eta_max); }, [&] { return eta; });
    case Cap::smooth: {
      const S share = eta / reg.eta_max;
      return eta / sqrt(1.0 + share * share);
    }
  }
  return eta;
}

/// Whether the cap takes away more than half of eta; arguments as `viscosity`.
[[nodiscard]] bool is_capped(const Law& law, const Grains& grains, const Regularisation& reg, double D_norm_squared,
                             double floor, double p);

}  // namespace talus::rheology
