#pragma once

#include <algorithm>

#include "two_fluid/grain_flux.hpp"
#include "two_fluid/terms/kernel.hpp"

namespace talus::two_fluid {

/// What a flux of mass m carries from behind to ahead beyond what the two volumes have: m (u_face - u_P) for either, with m the full
/// flux of mass, segregation included. That is (5.15) in conservative form less u times the balance of mass.
template <class S>
void carry(const Context& c, double area, const S& m, const S& behind, const S& ahead, S& row_behind, S& row_ahead) {
  const Numerics& n = c.parameters->numerics;
  const S u = n.advection == Advection::upwind ? fv::upwind_value(m, c.rho_air() * n.upwind_speed, behind, ahead)
                                               : S(0.5 * (behind + ahead));
  row_behind += area * m * (u - behind);
  row_ahead -= area * m * (u - ahead);
}

/// u carried along x, through the middle of cell (i, k).
struct ConvectionAlongAlong : Kernel {
  static constexpr int n_in = 10, n_out = 2;
  enum In { u_, phi_ = 2, heap_ = 7, beneath_ = 8 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    in[u_] = at->u(i, k);
    in[u_ + 1] = at->u(i + 1, k);
    for (int j = 1; j < 4; ++j) in[phi_ + j] = at->phi(i - 2 + j, k);
    in[phi_] = far_phi_at_face(i, k, i - 2);
    in[phi_ + 4] = far_phi_at_face(i + 1, k, i + 2);
    in[heap_] = heap_at_face(i, k) < 0 ? heap_at_face(i + 1, k) : heap_at_face(i, k);
    in[beneath_] = beneath_at_face(i, k);
    in[beneath_ + 1] = beneath_at_face(i + 1, k);
    out = {mesh->is_wall(i) ? -1 : at->momentum_u(i, k), mesh->is_wall(i + 1) ? -1 : at->momentum_u(i + 1, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const auto m = [&](int side) {
      const S* phi = &in.y[phi_ + side];
      const S& u = in.y[u_ + side];
      return mass_flux(c, u,
                       S(grain_flux_x(c, i + side, k, u, Row<S>{phi[0], phi[1], phi[2], phi[3]}, in.y[beneath_ + side],
                                      in.y[heap_])));
    };
    carry(c, grid().dz(k), S(0.5 * (m(0) + m(1))), in.y[u_], in.y[u_ + 1], out[0], out[1]);
  }
};

/// w carried along z, through the middle of cell (i, k).
struct ConvectionUpUp : Kernel {
  static constexpr int n_in = 8, n_out = 2;
  enum In { w_, phi_ = 2, heap_ = 7 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    in[w_] = at->w(i, k);
    in[w_ + 1] = at->w(i, k + 1);
    for (int j = 1; j < 4; ++j) in[phi_ + j] = at->phi(i, k - 2 + j);
    in[phi_] = far_phi_at_interface(i, k, k - 2);
    in[phi_ + 4] = far_phi_at_interface(i, k + 1, k + 2);
    in[heap_] = heap_at_interface(i, k + 1) < 0 ? heap_at_interface(i, k) : heap_at_interface(i, k + 1);
    out = {k > 0 ? at->momentum_w(i, k) : -1, mesh->is_inlet(i, k + 1) ? -1 : at->momentum_w(i, k + 1)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const auto m = [&](int side) {
      if (k + side == 0) return S(0.0);
      const S* phi = &in.y[phi_ + side];
      const S& w = in.y[w_ + side];
      return mass_flux(c, w, S(grain_flux_z(c, i, k + side, w, Row<S>{phi[0], phi[1], phi[2], phi[3]}, in.y[heap_])));
    };
    carry(c, grid().dx(i), S(0.5 * (m(0) + m(1))), in.y[w_], in.y[w_ + 1], out[0], out[1]);
  }
};

/// u carried along z, through the corner of face f and interface k.
struct ConvectionAlongUp : Kernel {
  static constexpr int n_in = 13, n_out = 2;
  enum In { u_, w_ = 2, phi_ = 4, heap_ = 12 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    in[u_] = at->u(f, k - 1);
    in[u_ + 1] = at->u(f, k);
    for (int side = 0; side < 2; ++side) {
      in[w_ + side] = at->w(f - 1 + side, k);
      std::ranges::copy(row_at_interface(f - 1 + side, k), &in[phi_ + 4 * side]);
    }
    in[heap_] = heap_at_interface(f - 1, k) < 0 ? heap_at_interface(f, k) : heap_at_interface(f - 1, k);
    out = {at->momentum_u(f, k - 1), at->momentum_u(f, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const auto m = [&](int side) {
      const S* phi = &in.y[phi_ + 4 * side];
      const S& w = in.y[w_ + side];
      const int i = f - 1 + side;
      return S(0.5 * grid().dx(i) *
               mass_flux(c, w, S(grain_flux_z(c, i, k, w, Row<S>{phi[0], phi[1], phi[2], phi[3]}, in.y[heap_]))));
    };
    const double area = grid().across_face(f);
    carry(c, area, S((m(0) + m(1)) / area), in.y[u_], in.y[u_ + 1], out[0], out[1]);
  }
};

/// w carried along x, through the same corner.
struct ConvectionUpAlong : Kernel {
  static constexpr int n_in = 15, n_out = 2;
  enum In { w_, u_ = 2, phi_ = 4, heap_ = 12, beneath_ = 13 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    in[w_] = at->w(f - 1, k);
    in[w_ + 1] = at->w(f, k);
    for (int side = 0; side < 2; ++side) {
      in[u_ + side] = at->u(f, k - 1 + side);
      std::ranges::copy(row_at_face(f, k - 1 + side), &in[phi_ + 4 * side]);
      in[beneath_ + side] = beneath_at_face(f, k - 1 + side);
    }
    in[heap_] = heap_at_face(f, k) < 0 ? heap_at_face(f, k - 1) : heap_at_face(f, k);
    out = {at->momentum_w(f - 1, k), at->momentum_w(f, k)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const auto m = [&](int side) {
      const S* phi = &in.y[phi_ + 4 * side];
      const S& u = in.y[u_ + side];
      const int layer = k - 1 + side;
      return S(0.5 * grid().dz(layer) *
               mass_flux(c, u,
                         S(grain_flux_x(c, f, layer, u, Row<S>{phi[0], phi[1], phi[2], phi[3]}, in.y[beneath_ + side],
                                        in.y[heap_]))));
    };
    const double area = grid().across_interface(k);
    carry(c, area, S((m(0) + m(1)) / area), in.y[w_], in.y[w_ + 1], out[0], out[1]);
  }
};

/// The momentum along the base of what is poured, brought to the uppermost volumes.
struct InletMomentum : Kernel {
  static constexpr int n_in = 3, n_out = 1;
  enum In { u_, w_ };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    in = {at->u(f, k - 1), mesh->is_inlet(f - 1, k) ? at->w(f - 1, k) : -1, mesh->is_inlet(f, k) ? at->w(f, k) : -1};
    out = {mesh->is_wall(f) ? -1 : at->momentum_u(f, k - 1)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const double rho = c.density(c.parameters->numerics.inlet_fraction);
    const S m = (0.5 * rho) * (grid().dx(f - 1) * in.y[w_] + grid().dx(f) * in.y[w_ + 1]);
    out[0] += m * (c.inlet_slip - in.y[u_]);
  }
};

}  // namespace talus::two_fluid
