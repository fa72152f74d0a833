#pragma once

#include <cmath>

#include "fv/sharp_transport.hpp"
#include "layer/film.hpp"
#include "layer/jet.hpp"
#include "layer/terms/kernel.hpp"

namespace talus::layer {

/// rho du/dt of (3.16) in the momentum volume about (face f, layer k), at a fixed layer of the moving grid.
struct Acceleration : Kernel {
  static constexpr int n_in = 9, n_out = 5;
  static constexpr bool uses_rate = true;
  enum In { u_, omega_, H_ = 5 };

  [[nodiscard]] Index n_places() const { return n_face_layers(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const auto& y = unknowns;
    in = {y.u(f, k), y.omega(f - 1, k), y.omega(f, k), y.omega(f - 1, k + 1), y.omega(f, k + 1), y.H(f - 2), y.H(f - 1),
          y.H(f),    y.H(f + 1)};
    connect_momentum(y, f, k, out, 0);
  }
  [[nodiscard]] Index alike(Index place) const { return alike_below(place, columns.n_layers); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const Heights<S, n_in> g(c, f - 2, in, H_);
    const S slope = g.slope_face(2, k);
    const S& a_x = in.rate[u_];
    S a_z = a_x * slope + in.y[u_] * g.slope_face_rate(2, k);
    for (int j = 0; j < 4; ++j) a_z += 0.25 * in.rate[omega_ + j];
    const S mass = c.parameters->grains.rho() * width(f) * g.h_face(2, k);
    scatter_momentum(S(mass * a_x), S(mass * a_z), slope, out, 0);
  }
};

/// rho (u . grad) u of (3.16) through the face of two momentum volumes that stands in the middle of cell (i, k). In the
/// form m (u_face - u_P), with the volume flux m that continuity knows, so that a uniform flow gives exactly nothing.
struct ConvectionAlong : Kernel {
  static constexpr int n_in = 13, n_out = 10;
  enum In { u_, omega_ = 2, H_ = 8 };

  [[nodiscard]] Index n_places() const { return n_cells(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = across(place), k = layer(place);
    const auto& y = unknowns;
    in[0] = y.u(i, k);
    in[1] = y.u(i + 1, k);
    for (int c = 0; c < 3; ++c) {
      in[omega_ + 2 * c] = y.omega(i - 1 + c, k);
      in[omega_ + 2 * c + 1] = y.omega(i - 1 + c, k + 1);
    }
    for (int c = 0; c < 5; ++c) in[H_ + c] = y.H(i - 2 + c);
    connect_momentum(y, i, k, out, 0);
    connect_momentum(y, i + 1, k, out, 5);
  }
  [[nodiscard]] Index alike(Index place) const { return alike_below(place, columns.n_layers); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int i = across(place), k = layer(place);
    const Numerics& n = c.parameters->numerics;
    const Heights<S, n_in> g(c, i - 2, in, H_);
    const S& u_left = in.y[u_];
    const S& u_right = in.y[u_ + 1];
    const S m = (0.5 * c.parameters->grains.rho() / columns.dx()) *
                (flux_through(n, g, left_end(i), false, 2, k, u_left) +
                 flux_through(n, g, false, right_end(i + 1), 3, k, u_right));
    std::array<S, 3> omega;
    for (int j = 0; j < 3; ++j) omega[j] = 0.5 * (in.y[omega_ + 2 * j] + in.y[omega_ + 2 * j + 1]);
    const S h = g.h(2, k);
    const auto scale = c.parameters->grains.rho() / columns.dx() * n.film_speed * core::value_of(h);
    const S u =
        n.advection == Advection::upwind ? fv::upwind_value(m, scale, u_left, u_right) : S(0.5 * (u_left + u_right));
    const S w = u * g.slope_centre(2, k) + omega[1];
    const auto leave = [&](const S& u_P, int face, double sign, int first) {
      const S slope = g.slope_face(face, k);
      const S w_P = u_P * slope + 0.5 * (omega[face - 2] + omega[face - 1]);
      scatter_momentum(S(sign * m * (u - u_P)), S(sign * m * (w - w_P)), slope, out, first);
    };
    leave(u_left, 2, 1.0, 0);
    leave(u_right, 3, -1.0, 5);
  }
};

/// rho (u . grad) u through interface k of face f, with the velocity of the grains relative to the moving interface.
struct ConvectionAcross : Kernel {
  static constexpr int n_in = 12, n_out = 10;
  static constexpr bool uses_rate = true;
  enum In { u_, omega_ = 2, H_ = 8 };

  [[nodiscard]] Index n_places() const { return Index{columns.n_faces()} * (columns.n_layers - 1); }
  [[nodiscard]] int face_of(Index place) const { return static_cast<int>(place) / (columns.n_layers - 1); }
  [[nodiscard]] int interface_of(Index place) const { return static_cast<int>(place) % (columns.n_layers - 1) + 1; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = face_of(place), k = interface_of(place);
    const auto& y = unknowns;
    in[0] = y.u(f, k - 1);
    in[1] = y.u(f, k);
    for (int c = 0; c < 2; ++c)
      for (int j = 0; j < 3; ++j) in[omega_ + 3 * c + j] = y.omega(f - 1 + c, k - 1 + j);
    for (int c = 0; c < 4; ++c) in[H_ + c] = y.H(f - 2 + c);
    connect_momentum(y, f, k - 1, out, 0);
    connect_momentum(y, f, k, out, 5);
  }
  [[nodiscard]] Index alike(Index place) const { return columns.n_layers - interface_of(place); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = face_of(place), k = interface_of(place);
    const Heights<S, n_in> g(c, f - 2, in, H_);
    std::array<S, 3> omega;  // on interfaces k - 1, k, k + 1
    for (int j = 0; j < 3; ++j) omega[j] = 0.5 * (in.y[omega_ + j] + in.y[omega_ + 3 + j]);
    const S grid_speed = g.z_face_rate(2, k);
    const double rho = c.parameters->grains.rho();
    const S m = (rho * width(f)) * (omega[1] - grid_speed);
    const S& u_below = in.y[u_];
    const S& u_above = in.y[u_ + 1];
    const Numerics& n = c.parameters->numerics;
    const S u = n.advection == Advection::upwind ? fv::upwind_value(m, rho * n.film_speed, u_below, u_above)
                                                 : S(0.5 * (u_below + u_above));
    const S w = u * g.slope_corner(2, k) + omega[1];
    const auto leave = [&](const S& u_P, int in_layer, double sign, int first) {
      const S slope = g.slope_face(2, in_layer);
      const int j = in_layer - k + 1;
      const S w_P = u_P * slope + 0.5 * (omega[j] + omega[j + 1]);
      scatter_momentum(S(sign * m * (u - u_P)), S(sign * m * (w - w_P)), slope, out, first);
    };
    leave(u_below, k - 1, 1.0, 0);
    leave(u_above, k, -1.0, 5);
  }
};

/// The momentum that the jet brings to the uppermost volumes: it arrives with the speed of its free fall from the inlet.
struct JetMomentum : Kernel {
  static constexpr double tiny_fall = 1e-10;  ///< of the box's height, added to the fall: keeps sqrt differentiable
  static constexpr int n_in = 9, n_out = 5;
  enum In { u_, omega_, H_ = 5 };

  [[nodiscard]] Index n_places() const { return columns.n_faces(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = static_cast<int>(place), k = columns.n_layers - 1;
    const auto& y = unknowns;
    in = {y.u(f, k), y.omega(f - 1, k), y.omega(f, k), y.omega(f - 1, k + 1), y.omega(f, k + 1), y.H(f - 2), y.H(f - 1),
          y.H(f),    y.H(f + 1)};
    connect_momentum(y, f, k, out, 0);
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    using std::sqrt;
    using core::sqrt;
    const Parameters& par = *c.parameters;
    const int f = static_cast<int>(place), k = columns.n_layers - 1;
    if (!columns.has_column(f - 1) || !columns.has_column(f)) return;
    const Heights<S, n_in> g(c, f - 2, in, H_);
    const S q =
        0.5 *
        (jet_rate(par, columns, columns.column(f - 1), S(0.5 * (g.H(0) + g.H(1))), S(0.5 * (g.H(1) + g.H(2))), c.t) +
         jet_rate(par, columns, columns.column(f), S(0.5 * (g.H(1) + g.H(2))), S(0.5 * (g.H(2) + g.H(3))), c.t));
    const double lean = par.inflow.along_gravity ? par.box.tilt : 0.0;
    const S fall = core::select_above(
        S(par.box.height - 0.5 * (g.H(1) + g.H(2))), 0.0, [&] { return S(par.box.height - 0.5 * (g.H(1) + g.H(2))); },
        [] { return S(0.0); });
    const double pull = 2.0 * par.box.gravity / std::cos(lean);
    const S speed = pull > 0.0 ? S(sqrt(pull * (fall + tiny_fall * par.box.height))) : S(0.0);
    const S slope = g.slope_face(2, k);
    const S& u = in.y[u_];
    const S w = u * slope + 0.25 * (in.y[omega_] + in.y[omega_ + 1] + in.y[omega_ + 2] + in.y[omega_ + 3]);
    const S m = par.grains.rho() * q;
    scatter_momentum(S(m * (u - std::sin(lean) * speed)), S(m * (w + std::cos(lean) * speed)), slope, out, 0);
  }
};

}  // namespace talus::layer
