#pragma once

#include "layer/film.hpp"
#include "layer/jet.hpp"
#include "layer/terms/kernel.hpp"

namespace talus::layer {

/// div u = 0 (3.9) and the surface's balance, d H/dt + d(sum F)/dx = source: the part of the volume fluxes F through faces.
/// One flux feeds the two cells and the two surfaces beside it with opposite signs, so mass is conserved to round-off.
struct FaceFlux : Kernel {
  static constexpr int n_in = 3, n_out = 4;
  enum In { u_, H_ };

  [[nodiscard]] Index n_places() const { return n_face_layers(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = across(place), k = layer(place);
    in = {unknowns.u(f, k), unknowns.H(f - 1), unknowns.H(f)};
    const bool left = columns.has_column(f - 1) && in[u_] >= 0, right = columns.has_column(f) && in[u_] >= 0;
    out = {left ? unknowns.continuity(f - 1, k) : -1, right ? unknowns.continuity(f, k) : -1,
           left ? unknowns.surface(f - 1) : -1, right ? unknowns.surface(f) : -1};
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const Heights<S> g(c, f - 1, &in.y[H_], &in.rate[H_]);
    const S F = flux_through(c.parameters->numerics, g, left_end(f), right_end(f), 1, k, in.y[u_]) / columns.dx();
    out[0] += F;
    out[1] -= F;
    out[2] += F;
    out[3] -= F;
  }
};

/// div u = 0: the part of the flux omega through interfaces.
struct InterfaceFlux : Kernel {
  static constexpr int n_in = 1, n_out = 2;

  [[nodiscard]] Index n_places() const { return n_cells(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = across(place), k = layer(place) + 1;
    in = {unknowns.omega(i, k)};
    out = {unknowns.continuity(i, k - 1), unknowns.continuity(i, k)};
  }
  template <class S>
  void evaluate(const Context&, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += in.y[0];
    out[1] -= in.y[0];
  }
};

/// The rate of the surface, dH/dt.
struct SurfaceRate : Kernel {
  static constexpr int n_in = 1, n_out = 1;
  static constexpr bool uses_rate = true;

  [[nodiscard]] Index n_places() const { return columns.n_columns; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {unknowns.H(static_cast<int>(place))};
    out = {unknowns.surface(static_cast<int>(place))};
  }
  template <class S>
  void evaluate(const Context&, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += in.rate[0];
  }
};

/// The mass that the jet brings to the surface of a column.
struct JetSource : Kernel {
  static constexpr int n_in = 1, n_out = 1;

  [[nodiscard]] Index n_places() const { return columns.n_columns; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {unknowns.H(static_cast<int>(place))};
    out = {unknowns.surface(static_cast<int>(place))};
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] -= jet_rate(*c.parameters, columns, static_cast<int>(place), in.y[0], c.t);
  }
};

}  // namespace talus::layer
