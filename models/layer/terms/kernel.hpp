#pragma once

#include <algorithm>

#include "fv/term.hpp"
#include "layer/context.hpp"
#include "layer/unknowns.hpp"

namespace talus::layer {

/// What every kernel of the layer model has: the grid, the numbers of the unknowns, and places on it.
struct Kernel {
  static constexpr bool uses_rate = false;
  grid::Columns columns;
  Unknowns unknowns;

  [[nodiscard]] Index n_cells() const { return Index{columns.n_columns} * columns.n_layers; }
  [[nodiscard]] Index n_face_layers() const { return Index{columns.n_faces()} * columns.n_layers; }
  [[nodiscard]] int across(Index place) const { return static_cast<int>(place) / columns.n_layers; }
  [[nodiscard]] int layer(Index place) const { return static_cast<int>(place) % columns.n_layers; }
  /// Places from this one on in layers up to that below `end`; of kernels with one place a layer.
  [[nodiscard]] Index alike_below(Index place, int end) const { return std::max(end - layer(place), 1); }
  /// Width of the momentum volume about face f, as a share of dx.
  [[nodiscard]] double width(int f) const { return columns.is_end(f) ? 0.5 : 1.0; }
  /// Whether the end faces of this kind leak: an open end, not a wall and not a seam.
  [[nodiscard]] bool left_end(int f) const { return !columns.periodic && f == 0 && unknowns.u(0, 0) >= 0; }
  [[nodiscard]] bool right_end(int f) const {
    return !columns.periodic && f == columns.n_columns && unknowns.u(f, 0) >= 0;
  }
};

/// The rows that the momentum volume about (face f, layer k) feeds: its own row along the layer, and a quarter each of its
/// vertical part to the four interfaces about it.
template <std::size_t N>
void connect_momentum(const Unknowns& y, int f, int k, std::array<Index, N>& out, int first) {
  out[first] = y.momentum_u(f, k);
  out[first + 1] = y.momentum_w(f - 1, k);
  out[first + 2] = y.momentum_w(f, k);
  out[first + 3] = y.momentum_w(f - 1, k + 1);
  out[first + 4] = y.momentum_w(f, k + 1);
}

/// Adds the vector (R_x, R_z) to those rows: R_x + slope R_z along the layer, the virtual power of u in (u, u slope + omega).
template <class S, std::size_t N>
void scatter_momentum(const S& R_x, const S& R_z, const S& slope, std::array<S, N>& out, int first) {
  out[first] += R_x + slope * R_z;
  const S quarter = 0.25 * R_z;
  for (int j = 1; j <= 4; ++j) out[first + j] += quarter;
}

}  // namespace talus::layer
