#pragma once

#include "layer/terms/kernel.hpp"

namespace talus::layer {

/// The lid over column i stays where it is.
struct LidHeight : Kernel {
  static constexpr int n_in = 1, n_out = 1;

  [[nodiscard]] Index n_places() const { return columns.n_columns; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = static_cast<int>(place);
    in = {unknowns.H(i)};
    out = {unknowns.lid(i)};
  }
  template <class S>
  void evaluate(const Context& c, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += in.y[0] - c.parameters->initial.thickness;
  }
};

/// The level of pressure in a closed box: that of the last column's top cell, less its weight above the middle, is the lid's.
/// (The volume of that cell needs no row: what flows into the others flows out of it.)
struct PressureLevel : Kernel {
  static constexpr int n_in = 2, n_out = 1;
  enum In { p_, H_ };

  [[nodiscard]] Index n_places() const { return 1; }
  void connect(Index, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const int i = columns.n_columns - 1;
    in = {unknowns.p(i, columns.n_layers - 1), unknowns.H(i)};
    out = {unknowns.pressure_level()};
  }
  template <class S>
  void evaluate(const Context& c, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const Parameters& par = *c.parameters;
    const Heights<S, n_in> g(c, columns.n_columns - 1, in, H_);
    const double on_lid = par.forcing ? par.forcing->lid_pressure(c.t) : par.box.lid->pressure;
    out[0] += in.y[p_] - (0.5 * c.weight_down) * g.h(0, columns.n_layers - 1) - on_lid;
  }
};

}  // namespace talus::layer
