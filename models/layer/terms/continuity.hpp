#pragma once

#include <vector>

#include "layer/film.hpp"
#include "layer/jet.hpp"
#include "layer/terms/kernel.hpp"

namespace talus::layer {

/// div u = 0 (3.9) and the surface's balance, d H/dt + d(sum F)/dx = source: the part of the volume fluxes F through faces.
/// One flux feeds the two cells and the two surfaces beside it with opposite signs, and the budget of an open end in place of
/// the cell that is not there: mass is conserved to round-off.
struct FaceFlux : Kernel {
  static constexpr int n_in = 3, n_out = 6;
  enum In { u_, H_ };

  [[nodiscard]] Index n_places() const { return n_face_layers(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = across(place), k = layer(place);
    in = {unknowns.u(f, k), unknowns.H(f - 1), unknowns.H(f)};
    const bool left = columns.has_column(f - 1) && in[u_] >= 0, right = columns.has_column(f) && in[u_] >= 0;
    out = {left ? unknowns.continuity(f - 1, k) : -1, right ? unknowns.continuity(f, k) : -1,
           left ? unknowns.surface(f - 1) : -1,       right ? unknowns.surface(f) : -1,
           left_end(f) ? unknowns.mass_left() : -1,   right_end(f) ? unknowns.mass_right() : -1};
  }
  [[nodiscard]] Index alike(Index place) const { return alike_below(place, columns.n_layers); }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const Parameters& par = *c.parameters;
    const Heights<S, n_in> g(c, f - 1, in, H_);
    const S F = flux_through(par.numerics, g, left_end(f), right_end(f), 1, k, in.y[u_]);
    const S volume_rate = F / columns.dx();
    out[0] += volume_rate;
    out[1] -= volume_rate;
    out[2] += volume_rate;
    out[3] -= volume_rate;
    const double mass = par.grains.rho() * par.box.gap;
    out[4] += mass * F;
    out[5] -= mass * F;
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
  [[nodiscard]] Index alike(Index place) const { return alike_below(place, columns.n_layers); }
  template <class S>
  void evaluate(const Context&, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += in.y[0];
    out[1] -= in.y[0];
  }
};

/// A rate alone: dH/dt of each surface, d(mass)/dt of each budget.
struct Rate : Kernel {
  static constexpr int n_in = 1, n_out = 1;
  static constexpr bool uses_rate = true;
  std::vector<Index> rows;

  [[nodiscard]] Index n_places() const { return static_cast<Index>(rows.size()); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {rows[place]};
    out = {rows[place]};
  }
  template <class S>
  void evaluate(const Context&, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += in.rate[0];
  }
};

/// The mass that the jet brings to the surface of a column.
struct JetSource : Kernel {
  static constexpr int n_in = 3, n_out = 1;

  [[nodiscard]] Index n_places() const { return columns.n_columns; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = static_cast<int>(place);
    in = {unknowns.H(i - 1), unknowns.H(i), unknowns.H(i + 1)};
    out = {unknowns.surface(i)};
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto i = static_cast<int>(place);
    const S left = 0.5 * (in.y[0] + in.y[1]), right = 0.5 * (in.y[1] + in.y[2]);
    out[0] -= jet_rate(*c.parameters, columns, i, left, right, c.t);
  }
};

/// The budget of the inflow: minus the rate at which mass is poured in, all of which lands within the box.
struct Poured : Kernel {
  static constexpr int n_in = 1, n_out = 1;

  [[nodiscard]] Index n_places() const { return 1; }
  void connect(Index, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {-1};
    out = {unknowns.mass_in()};
  }
  template <class S>
  void evaluate(const Context& c, Index, const fv::Inputs<S, n_in>&, std::array<S, n_out>& out) const {
    out[0] -= experiment::inflow_rate(c.parameters->inflow, c.t);
  }
};

}  // namespace talus::layer
