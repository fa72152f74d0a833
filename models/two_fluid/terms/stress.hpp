#pragma once

#include "two_fluid/mixture.hpp"
#include "two_fluid/terms/kernel.hpp"

namespace talus::two_fluid {

/// What the stress in the middle of cell (i, k) reads: u of three layers at its two faces, w of three columns on its two interfaces.
struct CentreSlots {
  static constexpr int n_in = 14;
  enum In { u_, w_ = 6, p_ = 12, phi_ = 13 };

  static void connect(const Unknowns& at, int i, int k, std::array<Index, n_in>& in) {
    for (int j = 0; j < 3; ++j)
      for (int side = 0; side < 2; ++side) in[u_ + 2 * j + side] = at.u(i + side, k - 1 + j);
    for (int j = 0; j < 3; ++j)
      for (int side = 0; side < 2; ++side) in[w_ + 2 * j + side] = at.w(i - 1 + j, k + side);
    in[p_] = at.p(i, k);
    in[phi_] = at.phi(i, k);
  }
  /// Deviator D_xx of the cell, free of what pours into it; D_xz the mean of its corners', a corner that is not amid cells bearing no shear.
  template <class S>
  static Strain<S> strain(const Mesh& mesh, int i, int k, const std::array<S, n_in>& y) {
    const auto& g = mesh.grid();
    S D_xz(0.0);
    for (int side = 0; side < 2; ++side) {
      for (int above = 0; above < 2; ++above) {
        const int f = i + side, interface = k + above;
        if (!mesh.is_amid(f, interface) && !mesh.is_on_base(f, interface)) continue;
        const S du = y[u_ + 2 * (above + 1) + side] - y[u_ + 2 * above + side];
        const S dw = y[w_ + 2 * (side + 1) + above] - y[w_ + 2 * side + above];
        D_xz += 0.125 * (du / g.across_interface(interface) + dw / g.across_face(f));
      }
    }
    return {S(0.5 * ((y[u_ + 3] - y[u_ + 2]) / g.dx(i) - (y[w_ + 3] - y[w_ + 2]) / g.dz(k))), D_xz};
  }
};

/// Normal stresses 2 eta D_xx and 2 eta D_zz of (5.15) in the middle of cell (i, k).
struct CentreStress : Kernel {
  static constexpr int n_in = CentreSlots::n_in, n_out = 4;

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    CentreSlots::connect(*at, i, k, in);
    out = {mesh->is_wall(i) ? -1 : at->momentum_u(i, k), mesh->is_wall(i + 1) ? -1 : at->momentum_u(i + 1, k),
           k > 0 ? at->momentum_w(i, k) : -1, mesh->is_inlet(i, k + 1) ? -1 : at->momentum_w(i, k + 1)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const auto strain = CentreSlots::strain(*mesh, i, k, in.y);
    const S eta =
        mixture_viscosity(c, in.y[CentreSlots::phi_], grain_viscosity(c, strain.norm_squared(), in.y[CentreSlots::p_]));
    const double dx = grid().dx(i), dz = grid().dz(k);
    const S pull_x = 2.0 * eta * strain.D_xx * dz;
    const S pull_z = 2.0 * eta * strain.D_xx * dx;  // D_zz = -D_xx
    out[0] -= pull_x;
    out[1] += pull_x;
    out[2] += pull_z;
    out[3] -= pull_z;
  }
};

/// What the shear stress at the corner of face f and interface k, amid four cells, reads.
struct CornerSlots {
  static constexpr int n_in = 16;
  enum In { u_, w_ = 6, p_ = 8, phi_ = 12 };

  static void connect(const Unknowns& at, int f, int k, std::array<Index, n_in>& in) {
    for (int side = 0; side < 2; ++side)
      for (int j = 0; j < 3; ++j) in[u_ + 3 * side + j] = at.u(f - 1 + j, k - 1 + side);
    for (int side = 0; side < 2; ++side) {
      in[w_ + side] = at.w(f - 1 + side, k);
      for (int above = 0; above < 2; ++above) {
        in[p_ + 2 * above + side] = at.p(f - 1 + side, k - 1 + above);
        in[phi_ + 2 * above + side] = at.phi(f - 1 + side, k - 1 + above);
      }
    }
  }
  template <class S>
  static Strain<S> strain(const Mesh& mesh, int f, int k, const std::array<S, n_in>& y) {
    const auto& g = mesh.grid();
    S D_xx(0.0);
    for (int above = 0; above < 2; ++above)
      for (int side = 0; side < 2; ++side)
        D_xx += (y[u_ + 3 * above + side + 1] - y[u_ + 3 * above + side]) * (0.25 / g.dx(f - 1 + side));
    return {D_xx, S(0.5 * ((y[u_ + 4] - y[u_ + 1]) / g.across_interface(k) + (y[w_ + 1] - y[w_]) / g.across_face(f)))};
  }
  /// p on the line between the middles of cells.
  template <class S>
  static S pressure(const Mesh& mesh, int f, int k, const std::array<S, n_in>& y) {
    const auto& g = mesh.grid();
    const double right = g.dx(f - 1) / (g.dx(f - 1) + g.dx(f)), above = g.dz(k - 1) / (g.dz(k - 1) + g.dz(k));
    return (1.0 - above) * ((1.0 - right) * y[p_] + right * y[p_ + 1]) +
           above * ((1.0 - right) * y[p_ + 2] + right * y[p_ + 3]);
  }
  /// phi of the volume about the corner.
  template <class S>
  static S fraction(const Mesh& mesh, int f, int k, const std::array<S, n_in>& y) {
    const auto& g = mesh.grid();
    const double right = g.dx(f) / (g.dx(f - 1) + g.dx(f)), above = g.dz(k) / (g.dz(k - 1) + g.dz(k));
    return (1.0 - above) * ((1.0 - right) * y[phi_] + right * y[phi_ + 1]) +
           above * ((1.0 - right) * y[phi_ + 2] + right * y[phi_ + 3]);
  }
};

/// Shear stress 2 eta D_xz of (5.15) at a corner amid four cells.
struct CornerStress : Kernel {
  static constexpr int n_in = CornerSlots::n_in, n_out = 4;

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    CornerSlots::connect(*at, f, k, in);
    out = {at->momentum_u(f, k - 1), at->momentum_u(f, k), at->momentum_w(f - 1, k), at->momentum_w(f, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const auto strain = CornerSlots::strain(*mesh, f, k, in.y);
    const S p = CornerSlots::pressure(*mesh, f, k, in.y);
    const S eta =
        mixture_viscosity(c, CornerSlots::fraction(*mesh, f, k, in.y), grain_viscosity(c, strain.norm_squared(), p));
    const S shear = 2.0 * eta * strain.D_xz;
    out[0] -= grid().across_face(f) * shear;
    out[1] += grid().across_face(f) * shear;
    out[2] -= grid().across_interface(k) * shear;
    out[3] += grid().across_interface(k) * shear;
  }
};

/// Shear stress of the base on the lowest layer about face f. With `base_film` grains that do not fill their cells lie on the base as
/// a film: its own thickness is sheared, not the cell's.
struct BaseStress : Kernel {
  static constexpr int n_in = 5, n_out = 1;
  static constexpr double thinnest = 0.02;  ///< a film, as a share of its cell
  enum In { u_, p_, phi_ = 3 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = place(number).i;
    in = {at->u(f, 0), at->p(f - 1, 0), at->p(f, 0), at->phi(f - 1, 0), at->phi(f, 0)};
    out = {mesh->is_wall(f) ? -1 : at->momentum_u(f, 0)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = place(number).i;
    const double left = mesh->has_cell(f - 1, 0) ? 0.5 * grid().dx(f - 1) : 0.0;
    const double right = mesh->has_cell(f, 0) ? 0.5 * grid().dx(f) : 0.0, width = left + right, dz = grid().dz(0);
    const auto mean = [&](const S& a, const S& b) { return S((left * a + right * b) / width); };
    const S& u = in.y[u_];
    const S phi = mean(in.y[phi_], in.y[phi_ + 1]);
    const S p = mean(in.y[p_], in.y[p_ + 1]) - (0.5 * dz * c.gravity_z * c.excess()) * phi;  // on the base
    const auto drawn = [&](const S& thickness) {  // by a layer of that thickness
      const S rate = u / (0.5 * thickness);
      return S(grain_viscosity(c, S(0.25 * rate * rate), p) * rate);
    };
    const double air = c.parameters->numerics.air.eta;
    if (c.parameters->numerics.base_film) {
      const S share = fv::above_zero(phi, share_onset);
      const S film = drawn(S(dz * (thinnest + (1.0 - thinnest) * share)));
      const S presence = share * (1.0 + thinnest) / (share + thinnest);
      out[0] += width * (presence * film + (1.0 - share) * air * u / (0.5 * dz));
      return;
    }
    const S rate = u / (0.5 * dz);
    out[0] += width * mixture_viscosity(c, phi, grain_viscosity(c, S(0.25 * rate * rate), p)) * rate;
  }
};

}  // namespace talus::two_fluid
