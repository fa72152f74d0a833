#pragma once

#include <array>

#include "column/context.hpp"
#include "fv/term.hpp"
#include "rheology/basal_slip.hpp"
#include "rheology/wall_friction.hpp"

namespace talus::column {

using core::Index;

/// What every kernel of the column has: unknown k is the speed u in layer k, and row k its balance of forces a unit area
/// of the base [Pa].
struct Kernel {
  int n_layers;
  [[nodiscard]] Index n_places() const { return n_layers; }
};

/// rho (du/dt - g sin zeta) in layer k.
struct Fall : Kernel {
  static constexpr int n_in = 1, n_out = 1;
  static constexpr bool uses_rate = true;

  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {place};
    out = {place};
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += c.heights->thickness(static_cast<int>(place)) * (c.parameters->grains.rho() * in.rate[0] - c.weight);
  }
};

/// Side-wall friction (2 mu_w/W) p_+ tanh(|u|/u_c) u/|u| of (3.16) on layer k, per thickness [Pa/m].
template <class S>
S wall_drag(const Context& c, double z, const S& u) {
  const double p = rheology::positive_pressure(c.pressure(z), c.parameters->regularisation.p_0);
  return (c.wall_friction * p) * u * rheology::friction_direction(S(u * u), c.parameters->wall.u_c);
}

struct WallFriction : Kernel {
  static constexpr int n_in = 1, n_out = 1;
  static constexpr bool uses_rate = false;

  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {place};
    out = {place};
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int k = static_cast<int>(place);
    out[0] += c.heights->thickness(k) * wall_drag(c, c.heights->centre[k], in.y[0]);
  }
};

/// eta [Pa s] (3.17) under pressure p [Pa] at shear rate du/dz [1/s]: D_norm = |du/dz|/2.
template <class S>
S shear_viscosity(const Context& c, const S& shear_rate, double p) {
  return rheology::viscosity(c.parameters->law, c.parameters->grains, c.parameters->regularisation,
                             S(0.25 * shear_rate * shear_rate), c.rate_floor, S(p));
}

/// Speed of the grains under interface k [m/s], given the speeds of the layers: on the base, k = 0, that at which they slip on it.
template <class S>
S speed_below(const Heights& at, double slip_length, int k, const S& below, const S& above) {
  return k > 0 ? below : S(rheology::slip_share(slip_length, at.distance(0)) * above);
}

/// Shear stress on the base [Pa], given the shear rate of grains that stick to it, or slip by Navier's length: less where its friction
/// does not hold them.
template <class S>
S base_stress(const Context& c, const S& shear_rate) {
  const double p = c.pressure(c.heights->interface[0]);
  const S stuck = shear_viscosity(c, shear_rate, p) * shear_rate;
  const auto& mu_b = c.parameters->box.base_friction;
  if (!mu_b) return stuck;
  const double limit = *mu_b * rheology::positive_pressure(p, c.parameters->regularisation.p_0);
  return rheology::limited_shear(stuck, S(stuck / limit));
}

/// Shear stress eta du/dz on interface k, upon which layer k pulls layer k - 1 along, or the base, k = 0. The surface bears no stress.
struct ShearStress : Kernel {
  static constexpr int n_in = 2, n_out = 2;
  static constexpr bool uses_rate = false;

  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {place - 1, place};
    out = in;
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int k = static_cast<int>(place);
    const S below = speed_below(*c.heights, c.parameters->box.base_slip_length, k, in.y[0], in.y[1]);
    const S shear_rate = (in.y[1] - below) / c.heights->distance(k);
    const S tau = k == 0 ? base_stress(c, shear_rate)
                         : S(shear_viscosity(c, shear_rate, c.pressure(c.heights->interface[k])) * shear_rate);
    out[0] -= tau;
    out[1] += tau;
  }
};

}  // namespace talus::column
