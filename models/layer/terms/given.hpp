#pragma once

#include "layer/terms/stress.hpp"

namespace talus::layer {

/// The given force on the momentum volume about (face f, layer k).
struct GivenForce : Kernel {
  static constexpr int n_in = 4, n_out = 5;

  [[nodiscard]] Index n_places() const { return n_face_layers(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = across(place), k = layer(place);
    for (int c = 0; c < 4; ++c) in[c] = unknowns.H(f - 2 + c);
    connect_momentum(unknowns, f, k, out, 0);
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = across(place), k = layer(place);
    const Heights<S, n_in> g(c, f - 2, in, 0);
    const auto force = c.parameters->forcing->force(f, k, c.t);
    const S volume = width(f) * g.h_face(2, k);
    scatter_momentum(S(-force.x * volume), S(-force.z * volume), g.slope_face(2, k), out, 0);
  }
};

/// The given pull along the free surface at face f.
struct GivenPull : Kernel {
  static constexpr int n_in = 4, n_out = 5;

  [[nodiscard]] Index n_places() const { return columns.n_faces(); }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int f = static_cast<int>(place);
    for (int c = 0; c < 4; ++c) in[c] = unknowns.H(f - 2 + c);
    connect_momentum(unknowns, f, columns.n_layers - 1, out, 0);
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const int f = static_cast<int>(place);
    const Heights<S, n_in> g(c, f - 2, in, 0);
    const auto pull = c.parameters->forcing->surface_pull(f, c.t);
    const int top = columns.n_layers - 1;
    scatter_momentum(S(-width(f) * pull.x), S(-width(f) * pull.z), g.slope_face(2, top), out, 0);
    if (columns.is_end(f)) return;
    // The uppermost half of the top layer is sheared on its sides, too.
    const S shear = shear_of(Traction<S>{S(pull.x), S(pull.z)}, g.slope_corner(2, top + 1)) * g.h_face(2, top) *
                    (0.5 / columns.dx());
    out[3] -= shear;
    out[4] += shear;
  }
};

/// The given pressure on the free surface of column i.
struct GivenPressure : Kernel {
  static constexpr int n_in = 1, n_out = 1;

  [[nodiscard]] Index n_places() const { return columns.n_columns; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {-1};
    out = {unknowns.momentum_w(static_cast<int>(place), columns.n_layers)};
  }
  template <class S>
  void evaluate(const Context& c, Index place, const fv::Inputs<S, n_in>&, std::array<S, n_out>& out) const {
    out[0] += c.parameters->forcing->surface_pressure(static_cast<int>(place), c.t);
  }
};

}  // namespace talus::layer
