#pragma once

#include "layer/terms/stress.hpp"

namespace talus::layer {

/// Traction of a rigid lid on the uppermost momentum volume of face f: the mirror image of the base's.
struct LidStress : Kernel {
  static constexpr int n_in = 11, n_out = 5;
  enum In { u_, omega_, p_ = 3, H_ = 7 };

  [[nodiscard]] Index n_places() const { return columns.n_faces(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = static_cast<int>(place), k = columns.n_layers - 1;
    const auto& y = unknowns;
    in = {y.u(f, k),  y.omega(f - 1, k), y.omega(f, k), y.p(f - 1, k - 1), y.p(f, k - 1), y.p(f - 1, k), y.p(f, k),
          y.H(f - 2), y.H(f - 1),        y.H(f),        y.H(f + 1)};
    connect_momentum(y, f, k, out, 0);
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = static_cast<int>(place), n = columns.n_layers;
    const Parameters& par = *c.parameters;
    const Heights<S, n_in> g(c, f - 2, in, H_);
    const S h = g.h_face(2, n - 1);
    const S slope = g.slope_corner(2, n), slope_mid = g.slope_face(2, n - 1);
    const S& u = in.y[u_];
    const S w_foot = 0.5 * (0.5 * (in.y[omega_] + in.y[omega_ + 1]));  // of omega, half-way between foot and lid
    const S p_top = 0.5 * (in.y[p_ + 2] + in.y[p_ + 3]);
    const S p = p_top + (p_top - 0.5 * (in.y[p_] + in.y[p_ + 1])) * h / (h + g.h_face(2, n - 2));
    const S H = 0.5 * (g.H(1) + g.H(2));
    Traction<S> T;
    if (top_of(par) == Top::free_slip) {
      T = smooth_wall_traction(par, S((u * (slope_mid - slope) + w_foot) / (0.5 * h)), slope, p, H);
    } else {
      const auto lid = sticking(lid_speed, c, f);
      const double U = lid.speed, stretch = lid.stretch;
      const S u_z = (U - u) / (0.5 * h);
      const S w_z = slope * u_z - stretch;
      const S w_x = stretch * slope + U * ((g.slope(2, n) - g.slope(1, n)) / columns.dx());
      const auto tau = stress(par, S(-w_z), S(0.5 * (u_z + w_x - slope * w_z)), p, H);
      T = {S(tau.xz - slope * tau.xx), S(-tau.xx - slope * tau.xz)};
    }
    scatter_momentum(S(-width(f) * T.x), S(-width(f) * T.z), slope_mid, out, 0);
  }
};

/// Normal stress at a free surface of a viscous fluid, in column i, and the pressure that bears it, so that the surface as a whole
/// is free. Grains need none of it: their stress vanishes with their pressure.
struct SurfaceStress : Kernel {
  static constexpr int n_in = 12, n_out = 6;
  enum In { u_, omega_ = 4, H_ = 7 };
  enum Out { above_, below_, along_, left_ = 4, right_ };

  [[nodiscard]] Index n_places() const { return columns.n_columns; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = static_cast<int>(place), k = columns.n_layers;
    const auto& y = unknowns;
    in = {y.u(i, k - 2),     y.u(i, k - 1), y.u(i + 1, k - 2), y.u(i + 1, k - 1),
          y.omega(i - 1, k), y.omega(i, k), y.omega(i + 1, k)};
    for (int j = 0; j < 5; ++j) in[H_ + j] = y.H(i - 2 + j);
    out = {y.momentum_w(i, k),
           y.momentum_w(i, k - 1),
           y.momentum_u(i, k - 1),
           y.momentum_u(i + 1, k - 1),
           columns.is_end(i) ? -1 : y.momentum_w(i - 1, k),
           columns.is_end(i + 1) ? -1 : y.momentum_w(i + 1, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int i = static_cast<int>(place), n = columns.n_layers;
    const double dx = columns.dx();
    const Heights<S, n_in> g(c, i - 2, in, H_);
    const S beyond = g.h(2, n - 1) / (g.h(2, n - 1) + g.h(2, n - 2));
    const S u_left = in.y[u_ + 1] + beyond * (in.y[u_ + 1] - in.y[u_]);
    const S u_right = in.y[u_ + 3] + beyond * (in.y[u_ + 3] - in.y[u_ + 2]);
    const S slope = g.slope(2, n);
    const S bend = (g.slope_corner(3, n) - g.slope_corner(2, n)) / dx;
    const S omega_x = (in.y[omega_ + 2] - in.y[omega_]) * (0.5 / dx);
    const S stretch =
        (u_right - u_left) / dx + slope * (0.5 * (u_left + u_right) * bend + omega_x) / (1.0 + slope * slope);
    const S p = (-2.0 * c.parameters->fluid->eta) * stretch;
    out[above_] += 0.5 * p;
    out[below_] -= 0.5 * p;
    for (const int face : {2, 3}) {  // half of p stands over either
      const S s = g.slope_corner(face, n);
      const double share = columns.is_end(i + face - 2) ? 0.5 : 1.0;
      out[along_ + face - 2] += (0.5 * share) * p * (s - g.slope_face(face, n - 1));
      if (columns.is_end(i + face - 2)) continue;
      const S shear = shear_of(Traction<S>{S(-0.5 * s * p), S(0.5 * p)}, s) * g.h_face(face, n - 1) * (0.5 / dx);
      const double sign = face == 2 ? 1.0 : -1.0;
      out[above_] += sign * shear;
      out[face == 2 ? left_ : right_] -= sign * shear;
    }
  }
};

}  // namespace talus::layer
