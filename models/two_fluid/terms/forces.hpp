#pragma once

#include <algorithm>

#include "rheology/viscosity.hpp"
#include "rheology/wall_friction.hpp"
#include "two_fluid/terms/kernel.hpp"

namespace talus::two_fluid {

/// rho du/dt - (rho - rho_air) g_x + dp/dx of (5.15) in the momentum volume about face (f, k), p being the pressure over that of still air,
/// and the drag of the side walls on the air in it.
/// Through a wall nothing passes: u = 0.
struct MomentumAlong : Kernel {
  static constexpr int n_in = 5, n_out = 1;
  static constexpr bool uses_rate = true;
  enum In { u_, phi_, p_ = 3 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    in = {at->u(f, k), at->phi(f - 1, k), at->phi(f, k), at->p(f - 1, k), at->p(f, k)};
    out = {at->momentum_u(f, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const double left = half_cell(f - 1, k), right = half_cell(f, k);
    if (mesh->is_wall(f)) {
      out[0] += (c.parameters->grains.rho() / c.fall_time() * (left + right)) * in.y[u_];
      return;
    }
    const S grains = left * in.y[phi_] + right * in.y[phi_ + 1],
            mass = c.rho_air() * (left + right) + c.excess() * grains;
    const S air = left + right - grains;
    out[0] += mass * in.rate[u_] - (c.excess() * c.gravity_x) * grains + grid().dz(k) * (in.y[p_ + 1] - in.y[p_]) +
              c.air_drag * air * in.y[u_];
  }
};

/// The same along z about interface (i, k). At the inlet w is what is poured.
struct MomentumUp : Kernel {
  static constexpr int n_in = 5, n_out = 1;
  static constexpr bool uses_rate = true;
  enum In { w_, phi_, p_ = 3 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    in = {at->w(i, k), at->phi(i, k - 1), at->phi(i, k), at->p(i, k - 1), at->p(i, k)};
    out = {at->momentum_w(i, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const double below = half_cell(i, k - 1), above = half_cell(i, k);
    if (mesh->is_inlet(i, k)) {
      out[0] +=
          (c.parameters->grains.rho() / c.fall_time() * below) * (in.y[w_] + c.inlet_speed * mesh->inlet_share(i));
      return;
    }
    const S grains = below * in.y[phi_] + above * in.y[phi_ + 1],
            mass = c.rho_air() * (below + above) + c.excess() * grains;
    const S air = below + above - grains;
    out[0] += mass * in.rate[w_] - (c.excess() * c.gravity_z) * grains + grid().dx(i) * (in.y[p_ + 1] - in.y[p_]) +
              c.air_drag * air * in.y[w_];
  }
};

/// The two halves of a momentum volume: their sizes [m2], and the longer cell's length along the component [m].
struct Halves {
  double first, second, length;
};

/// Side-wall friction (2 Omega/W) phi mu_w p u/|u| of (5.15) on the component u that is known at a place, `across` the other one,
/// taken there; with phi and p of the two halves of the momentum volume, weighted as friction itself makes pressure fall.
template <class S>
S wall_drag(const Context& c, const Halves& halves, const S& u, const S& across, const S* phi, const S* p,
            const S& omega) {
  const double p_0 = c.parameters->regularisation.p_0;
  const Wall& wall = c.parameters->wall;
  const double a_unit_length = 2.0 * wall.mu_w / c.parameters->box.gap;
  const S turn = rheology::friction_direction(S(u * u + across * across), wall.u_c);
  const S direction = omega * turn * u;
  const S behind = rheology::weight_behind(S(a_unit_length * halves.length * direction));
  const S load = 2.0 * halves.first * behind * phi[0] * rheology::positive_pressure(p[0], p_0) +
                 2.0 * halves.second * (1.0 - behind) * phi[1] * rheology::positive_pressure(p[1], p_0);
  return a_unit_length * load * direction;
}

struct WallFrictionAlong : Kernel {
  static constexpr int n_in = 10, n_out = 1;
  enum In { u_, w_, phi_ = 5, p_ = 7, heap_ = 9 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    in = {at->u(f, k),       at->w(f - 1, k), at->w(f - 1, k + 1), at->w(f, k), at->w(f, k + 1),
          at->phi(f - 1, k), at->phi(f, k),   at->p(f - 1, k),     at->p(f, k), heap_at_face(f, k)};
    out = {mesh->is_wall(f) ? -1 : at->momentum_u(f, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const double share = mesh->has_cell(f - 1, k) && mesh->has_cell(f, k) ? 0.25 : 0.5;
    const S w = share * (in.y[w_] + in.y[w_ + 1] + in.y[w_ + 2] + in.y[w_ + 3]);
    const S omega = mesh->jet().omega(grid().x_nodes[f], grid().z_centre(k), in.y[heap_]);
    out[0] += wall_drag(c, {half_cell(f - 1, k), half_cell(f, k), std::max(grid().dx(f - 1), grid().dx(f))}, in.y[u_],
                        w, &in.y[phi_], &in.y[p_], omega);
  }
};

struct WallFrictionUp : Kernel {
  static constexpr int n_in = 10, n_out = 1;
  enum In { w_, u_, phi_ = 5, p_ = 7, heap_ = 9 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    in = {at->w(i, k),       at->u(i, k - 1), at->u(i + 1, k - 1), at->u(i, k), at->u(i + 1, k),
          at->phi(i, k - 1), at->phi(i, k),   at->p(i, k - 1),     at->p(i, k), heap_at_interface(i, k)};
    out = {mesh->is_inlet(i, k) ? -1 : at->momentum_w(i, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const double share = mesh->has_cell(i, k - 1) && mesh->has_cell(i, k) ? 0.25 : 0.5;
    const S u = share * (in.y[u_] + in.y[u_ + 1] + in.y[u_ + 2] + in.y[u_ + 3]);
    const S omega = mesh->jet().omega(grid().x_centre(i), grid().z_nodes[k], in.y[heap_]);
    out[0] += wall_drag(c, {half_cell(i, k - 1), half_cell(i, k), std::max(grid().dz(k - 1), grid().dz(k))}, in.y[w_],
                        u, &in.y[phi_], &in.y[p_], omega);
  }
};

}  // namespace talus::two_fluid
