#pragma once

#include <numbers>
#include <optional>

#include "layer/bounds.hpp"
#include "layer/terms/kernel.hpp"
#include "rheology/basal_slip.hpp"

namespace talus::layer {

/// Deviatoric stress tau = 2 eta D (3.17) in the plane, trace-free: tau_zz = -tau_xx.
template <class S>
struct Stress {
  S xx, xz;
};

template <class S>
Stress<S> stress(const Parameters& par, const S& D_xx, const S& D_xz, const S& p, const S& H) {
  if (par.fluid) return {(2.0 * par.fluid->eta) * D_xx, (2.0 * par.fluid->eta) * D_xz};
  const auto& reg = par.regularisation;
  // Few arguments, many inputs: derivatives by the arguments first.
  const S eta = core::through(
      [&]<class T>(const T& D_norm_squared, const T& pressure, const T& thickness) {
        return reg.rate_speed > 0.0
                   ? rheology::viscosity(par.law, par.grains, reg, T(D_norm_squared + reg.rate_floor * reg.rate_floor),
                                         T(reg.rate_speed / thickness), pressure)
                   : rheology::viscosity(par.law, par.grains, reg, D_norm_squared, reg.rate_floor, pressure);
      },
      S(D_xx * D_xx + D_xz * D_xz), p, H);
  const S two_eta = 2.0 * eta;
  return {two_eta * D_xx, two_eta * D_xz};
}

/// Share of the grains' speed over the base, `distance` above it along z, at which they slip on a base of that slope; an immobile film
/// sticks, as it does whatever the base's friction.
template <class S>
S base_slip_share(double slip_length, const S& mobility, const S& slope, const S& distance) {
  using std::sqrt;
  using core::sqrt;
  return rheology::slip_share(S(slip_length * mobility * sqrt(S(1.0 + slope * slope))), distance);
}

/// Strain rate at a cell corner: interface k of face f, k < n_layers. The shear across layers is one compact difference;
/// D_xx follows from D_zz by incompressibility; on the base the velocity below is the base's, and where grains stick to it (`base`),
/// so is the stretch along it; where they slip by Navier's length, both are partly those of the lowest layer.
template <class S>
struct CornerStrain {
  S D_xx, D_xz;
};

/// Inputs of the corner stencil, shared by stress and diagnostics.
struct CornerSlots {
  enum In { u_, omega_ = 2, p_ = 8, H_ = 12 };
  static constexpr int n_in = 16;
  static void connect(const Unknowns& y, int f, int k, std::array<Index, n_in>& in) {
    in[0] = y.u(f, k - 1);
    in[1] = y.u(f, k);
    for (int c = 0; c < 2; ++c)
      for (int j = 0; j < 3; ++j) in[omega_ + 3 * c + j] = y.omega(f - 1 + c, k - 1 + j);
    const int below = k > 0 ? k - 1 : 1;  // on the base the pressure is extrapolated from the two lowest layers
    in[p_] = y.p(f - 1, below);
    in[p_ + 1] = y.p(f, below);
    in[p_ + 2] = y.p(f - 1, k);
    in[p_ + 3] = y.p(f, k);
    for (int c = 0; c < 4; ++c) in[H_ + c] = y.H(f - 2 + c);
  }
};

template <class S, int N>
CornerStrain<S> corner_strain(const Heights<S, N>& g, int k, double dx, const std::optional<Sticking>& base,
                              const std::array<S, CornerSlots::n_in>& y) {
  const S* omega_left = &y[CornerSlots::omega_];
  const S* omega_right = omega_left + 3;
  const auto omega = [&](int j) { return S(0.5 * (omega_left[j] + omega_right[j])); };
  const S& u_above = y[1];
  S u_below = k > 0 ? y[0] : (base ? S(base->speed) : u_above);
  S base_stretch(base ? base->stretch : 0.0);
  const S slope = g.slope_corner(2, k);
  const S w_above = u_above * g.slope_face(2, k) + 0.5 * (omega(1) + omega(2));
  const S dz = k > 0 ? S(0.5 * (g.h_face(2, k - 1) + g.h_face(2, k))) : S(0.5 * g.h_face(2, 0));
  if (k == 0 && base && base->slip_length > 0.0) {
    const S share = base_slip_share(base->slip_length, S(0.5 * (g.mobility(1) + g.mobility(2))), slope, dz);
    const S over = u_above - base->speed, thickens = g.slope_corner(2, 1) - slope;
    // Along the lowest layer its grains stretch by what leaves it; the share falls as the layer thickens.
    base_stretch += share * (-0.5 * (omega(2) + u_above * thickens) / dz - base->stretch);
    base_stretch -= share * (1.0 - share) * over * (0.5 * thickens / dz);
    u_below += share * over;
  }
  const S w_below = k > 0 ? S(u_below * g.slope_face(2, k - 1) + 0.5 * (omega(0) + omega(1))) : S(u_below * slope);
  const S u = k > 0 ? S(0.5 * (u_below + u_above)) : u_below;
  const S u_z = (u_above - u_below) / dz;
  // A one-sided dw/dz would be of order 1, and p of the lowest layer with it.
  const S w_z = k == 0 && base ? S(slope * u_z - base_stretch) : S((w_above - w_below) / dz);
  const S stretch = slope * u_z - w_z;  // du/dx along the layer
  const S w_x = stretch * slope + u * ((g.slope(2, k) - g.slope(1, k)) / dx) + (omega_right[1] - omega_left[1]) / dx;
  return {-w_z, S(0.5 * (u_z + w_x - slope * w_z))};
}

/// Pressure at a corner, linear between the layers on both sides, so that a lithostatic pressure is exact.
template <class S, int N>
S corner_pressure(const Heights<S, N>& g, int k, const std::array<S, CornerSlots::n_in>& y) {
  const S p_k = 0.5 * (y[CornerSlots::p_ + 2] + y[CornerSlots::p_ + 3]);
  const S p_other = 0.5 * (y[CornerSlots::p_] + y[CornerSlots::p_ + 1]);
  if (k == 0) return p_k + (p_k - p_other) * g.h_face(2, 0) / (g.h_face(2, 0) + g.h_face(2, 1));
  const S h_below = g.h_face(2, k - 1), h_above = g.h_face(2, k);
  return (p_other * h_above + p_k * h_below) / (h_below + h_above);
}

/// Force tau n of a stress per unit length of x on a line with normal n = (-slope, 1).
template <class S>
struct Traction {
  S x, z;
};

/// tau_xz where the traction on a line of that slope is T.
template <class S>
S shear_of(const Traction<S>& T, const S& slope) {
  return (T.x - slope * T.z) / (1.0 + slope * slope);
}

/// The shear along a line of that slope per unit length of the line, where the traction on it is T.
template <class S>
S shear_along(const Traction<S>& T, const S& slope) {
  return (T.x + slope * T.z) / (1.0 + slope * slope);
}

/// Traction on a wall without shear stress, given how fast the grains along it stretch: normal to it.
template <class S>
Traction<S> smooth_wall_traction(const Parameters& par, const S& stretch, const S& slope, const S& p, const S& H) {
  const auto tau = stress(par, stretch, S(0.0), p, H);  // along the wall
  return {S(slope * tau.xx), S(-tau.xx)};
}

/// Traction on interface k between two momentum volumes of face f, and the shear on the upright face between the two
/// vertical-momentum volumes beside it: at an end, on the wall if grains stick to it. The surface (k = n_layers) is free of
/// traction here.
struct CornerStress : Kernel, CornerSlots {
  static constexpr int n_in = CornerSlots::n_in, n_out = 12;

  [[nodiscard]] Index n_places() const { return n_face_layers(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = across(place), k = layer(place);
    CornerSlots::connect(unknowns, f, k, in);
    out.fill(-1);
    if (k > 0) connect_momentum(unknowns, f, k - 1, out, 0);
    connect_momentum(unknowns, f, k, out, 5);
    if (k > 0 && (!columns.is_end(f) || sticks(f))) {
      if (columns.has_column(f - 1)) out[10] = unknowns.momentum_w(f - 1, k);
      if (columns.has_column(f)) out[11] = unknowns.momentum_w(f, k);
    }
  }
  [[nodiscard]] Index alike(Index place) const { return layer(place) == 0 ? 1 : alike_below(place, columns.n_layers); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const Parameters& par = *c.parameters;
    const Heights<S, n_in> g(c, f - 2, in, H_);
    const S p = corner_pressure(g, k, in.y);
    const S H = 0.5 * (g.H(1) + g.H(2));
    const S slope = g.slope_corner(2, k);
    if (k == 0 && par.box.base == Contact::free_slip) {
      const S rise = in.y[1] * (slope - g.slope_face(2, 0)) - 0.5 * (0.5 * (in.y[omega_ + 2] + in.y[omega_ + 5]));
      const auto T = smooth_wall_traction(par, S(rise / (0.5 * g.h_face(2, 0))), slope, p, H);
      scatter_momentum(S(width(f) * T.x), S(width(f) * T.z), g.slope_face(2, k), out, 5);
      return;
    }
    const auto strain =
        corner_strain(g, k, columns.dx(), k == 0 ? std::optional(base_contact(c, f)) : std::nullopt, in.y);
    const auto tau = stress(par, strain.D_xx, strain.D_xz, p, H);
    S T_x = width(f) * (tau.xz - slope * tau.xx);
    S T_z = width(f) * (-tau.xx - slope * tau.xz);
    if (k == 0 && par.box.base_friction) {
      const S stuck = shear_along(Traction<S>{T_x, T_z}, slope) / width(f);
      const S limit = *par.box.base_friction * rheology::positive_pressure(p, par.regularisation.p_0);
      // A base holds the immobile film, whose grains never leave, whatever its friction: sliding it would gain speed for ever.
      const S mobile = 0.5 * (g.mobility(1) + g.mobility(2));
      const S less = width(f) * (rheology::limited_shear(stuck, S(mobile * stuck / limit)) - stuck);
      T_x += less;
      T_z += slope * less;
    }
    if (k > 0) scatter_momentum(S(-T_x), S(-T_z), g.slope_face(2, k - 1), out, 0);
    scatter_momentum(T_x, T_z, g.slope_face(2, k), out, 5);
    if (k > 0) {
      const S shear = (0.5 / columns.dx()) * (g.h_face(2, k - 1) + g.h_face(2, k)) * tau.xz;
      out[10] -= shear;
      out[11] += shear;
    }
  }

 private:
  /// Whether face f is a wall to which grains stick: omega then changes its sign across it.
  [[nodiscard]] bool sticks(int f) const { return unknowns.omega(f - 1, 1) < -1 || unknowns.omega(f, 1) < -1; }
};

/// Inputs of the cell-centre stencil, shared by stress and diagnostics.
struct CentreSlots {
  enum In { u_, omega_ = 6, p_ = 12, H_ = 13 };
  static constexpr int n_in = 18;
  static void connect(const Unknowns& y, int i, int k, std::array<Index, n_in>& in) {
    for (int c = 0; c < 2; ++c)
      for (int j = 0; j < 3; ++j) in[u_ + 3 * c + j] = y.u(i + c, k - 1 + j);
    for (int c = 0; c < 3; ++c) {
      in[omega_ + 2 * c] = y.omega(i - 1 + c, k);
      in[omega_ + 2 * c + 1] = y.omega(i - 1 + c, k + 1);
    }
    in[p_] = y.p(i, k);
    for (int c = 0; c < 5; ++c) in[H_ + c] = y.H(i - 2 + c);
  }
};

template <class S, int N>
CornerStrain<S> centre_strain(const Heights<S, N>& g, int k, int n_layers, double dx, const Bounds& bounds,
                              const std::array<S, CentreSlots::n_in>& y) {
  const auto u = [&](int j) { return S(0.5 * (y[j] + y[3 + j])); };
  const auto omega_mean = [&](int c) {
    return S(0.5 * (y[CentreSlots::omega_ + 2 * c] + y[CentreSlots::omega_ + 2 * c + 1]));
  };
  const S h = g.h(2, k);
  // Below and above, either the next layer, or a wall, or the mirror image beyond a boundary free of shear.
  const bool on_smooth_base = k == 0 && bounds.base == Contact::free_slip;
  S u_below = k > 0 ? u(0) : (on_smooth_base ? u(1) : S(bounds.base_speed));
  if (k == 0 && bounds.base_slip_length > 0.0)
    u_below += base_slip_share(bounds.base_slip_length, g.mobility(2), g.slope(2, 0), S(0.5 * h)) * (u(1) - u_below);
  const S reach_down = k > 0 ? S(0.5 * (g.h(2, k - 1) + h)) : (on_smooth_base ? h : S(0.5 * h));
  S u_z;
  if (k == 0 && bounds.base_slides) {
    u_z = (u(2) - u(1)) / (0.5 * (h + g.h(2, k + 1)));  // how fast the grains slide on the base is not known
  } else if (k < n_layers - 1) {
    u_z = (u(2) - u_below) / (reach_down + 0.5 * (h + g.h(2, k + 1)));
  } else if (bounds.top == Top::grains) {
    // Under a free surface I varies slowly and p grows as the depth: shear grows as its square root, from the middle of the
    // top layer to its foot by sqrt(2).
    u_z = (u(1) - u_below) / reach_down * std::numbers::sqrt2 * 0.5;
  } else if (bounds.top == Top::fluid) {
    u_z = (u(1) - u_below) / reach_down;
  } else if (bounds.top == Top::no_slip) {
    u_z = (bounds.lid_speed - u_below) / (reach_down + 0.5 * h);
  } else {
    u_z = (u(1) - u_below) / (reach_down + h);
  }
  const S slope = g.slope_centre(2, k);
  const S u_x = (y[4] - y[1]) / dx;
  const S omega_z = (y[CentreSlots::omega_ + 3] - y[CentreSlots::omega_ + 2]) / h;
  const S w_z = slope * u_z + u(1) * (g.slope(2, k + 1) - g.slope(2, k)) / h + omega_z;
  const S w_x = u_x * slope + u(1) * ((g.slope_face(3, k) - g.slope_face(2, k)) / dx) +
                (omega_mean(2) - omega_mean(0)) * (0.5 / dx);
  return {S(u_x - slope * u_z), S(0.5 * (u_z + w_x - slope * w_z))};
}

/// Traction on the upright face between two momentum volumes, in the middle of cell (i, k).
struct CentreStress : Kernel, CentreSlots {
  static constexpr int n_in = CentreSlots::n_in, n_out = 2;

  [[nodiscard]] Index n_places() const { return n_cells(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = across(place), k = layer(place);
    CentreSlots::connect(unknowns, i, k, in);
    out = {unknowns.momentum_u(i, k), unknowns.momentum_u(i + 1, k)};
  }
  [[nodiscard]] Index alike(Index place) const {
    return layer(place) == 0 ? 1 : alike_below(place, columns.n_layers - 1);
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int i = across(place), k = layer(place);
    const Heights<S, n_in> g(c, i - 2, in, H_);
    const auto strain = centre_strain(g, k, columns.n_layers, columns.dx(), bounds(c, i), in.y);
    const auto tau = stress(*c.parameters, strain.D_xx, strain.D_xz, in.y[p_], g.H(2));
    const S area = g.h(2, k) / columns.dx();
    out[0] -= area * (tau.xx + g.slope_face(2, k) * tau.xz);
    out[1] += area * (tau.xx + g.slope_face(3, k) * tau.xz);
  }
};

}  // namespace talus::layer
