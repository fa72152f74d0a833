#pragma once

#include <cmath>

#include "layer/terms/kernel.hpp"
#include "rheology/wall_friction.hpp"

namespace talus::layer {

/// Side-wall friction (2 mu_w/W) p u/|u| of (3.16) on the momentum volume about (face f, layer k).
struct WallFriction : Kernel {
  static constexpr int n_in = 11, n_out = 5;
  enum In { u_, omega_, p_ = 5, H_ = 7 };

  [[nodiscard]] Index n_places() const { return n_face_layers(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const auto& y = unknowns;
    in = {y.u(f, k),         y.omega(f - 1, k),
          y.omega(f, k),     y.omega(f - 1, k + 1),
          y.omega(f, k + 1), y.p(f - 1, k),
          y.p(f, k),         y.H(f - 2),
          y.H(f - 1),        y.H(f),
          y.H(f + 1)};
    connect_momentum(y, f, k, out, 0);
  }
  [[nodiscard]] Index alike(Index place) const { return alike_below(place, columns.n_layers); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const Parameters& par = *c.parameters;
    const Heights<S, n_in> g(c, f - 2, in, H_);
    const S slope = g.slope_face(2, k);
    const S& u = in.y[u_];
    const S w = u * slope + 0.25 * (in.y[omega_] + in.y[omega_ + 1] + in.y[omega_ + 2] + in.y[omega_ + 3]);
    const S p = rheology::positive_pressure(S(0.5 * (in.y[p_] + in.y[p_ + 1])), par.regularisation.p_0);
    const S drag =
        (2.0 * par.wall.mu_w / par.box.gap * width(f)) * g.h_face(2, k) * p *
        core::through(
            [&](const auto& speed_squared) { return rheology::friction_direction(speed_squared, par.wall.u_c); },
            S(u * u + w * w));
    scatter_momentum(S(drag * u), S(drag * w), slope, out, 0);
  }
};

/// -grad p + rho g along a layer. The slope is the compact one between two columns, for which a lithostatic pressure under
/// any surface leaves exactly the weight along that surface, kinks and sawteeth included.
struct PressureAlong : Kernel {
  static constexpr int n_in = 4, n_out = 1;
  enum In { p_, H_ = 2 };

  [[nodiscard]] Index n_places() const { return n_face_layers(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = across(place), k = layer(place);
    in = {columns.has_column(f - 1) ? unknowns.p(f - 1, k) : -1, columns.has_column(f) ? unknowns.p(f, k) : -1,
          unknowns.H(f - 1), unknowns.H(f)};
    out = {unknowns.momentum_u(f, k)};
  }
  [[nodiscard]] Index alike(Index place) const { return alike_below(place, columns.n_layers); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const Heights<S, n_in> g(c, f - 1, in, H_);
    const S weight = width(f) * (c.weight_along - c.weight_down * g.rise(1, k));
    out[0] += g.h_face(1, k) * ((in.y[p_ + 1] - in.y[p_]) / columns.dx() - weight);
  }
};

/// -dp/dz + rho g_z on interface k >= 1 of column i; the pressure above the surface is zero.
struct PressureAcross : Kernel {
  static constexpr int n_in = 3, n_out = 1;
  enum In { p_, H_ = 2 };

  [[nodiscard]] Index n_places() const { return n_cells(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = across(place), k = layer(place) + 1;
    in = {unknowns.p(i, k - 1), unknowns.p(i, k), unknowns.H(i)};
    out = {unknowns.momentum_w(i, k)};
  }
  [[nodiscard]] Index alike(Index place) const { return alike_below(place, columns.n_layers - 1); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int i = across(place), k = layer(place) + 1;
    const Heights<S, n_in> g(c, i, in, H_);
    const S between = k < columns.n_layers ? S(0.5 * (g.h(0, k - 1) + g.h(0, k))) : S(0.5 * g.h(0, k - 1));
    out[0] += in.y[p_ + 1] - in.y[p_] + c.weight_down * between;
  }
};

}  // namespace talus::layer
