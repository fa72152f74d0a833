#pragma once

#include "grid/columns.hpp"

namespace talus::layer {

using grid::Index;

/// Which budgets a scene needs beside the fields of the layer.
struct Budgets {
  bool inflow = false;  ///< mass poured in
  bool left = false;    ///< mass that left over the left end
  bool right = false;   ///< mass that left over the right end
};

/// Numbers of the unknowns, column by column, and of the equation rows that carry the same numbers.
/// Column i owns, for each layer from the base up, u at its left face, omega at the layer's upper interface and p in the
/// cell; then its thickness H. The faces at the far end follow. Budgets stand beside the end whose flux they sum, so that the
/// Jacobian stays a narrow band. A left wall has no u: column 0 then owns omega and p alone, and H. -1 stands for "not an
/// unknown": it reads as zero.
class Unknowns {
 public:
  Unknowns(const grid::Columns& columns, bool left_wall, Budgets budgets)
      : c_(columns), left_wall_(left_wall && !columns.periodic), budgets_(budgets), first_(budgets.left ? 1 : 0) {}

  [[nodiscard]] Index size() const { return past_columns() + (budgets_.right ? 1 : 0) + (budgets_.inflow ? 1 : 0); }
  /// Velocity along x at face f, layer k [m/s]; zero at a wall.
  [[nodiscard]] Index u(int f, int k) const {
    if (k < 0 || k >= c_.n_layers || !c_.has_face(f) || (left_wall_ && f == 0)) return -1;
    const int face = c_.face(f);
    return start(face) + (face == c_.n_columns ? k : 3 * k);
  }
  /// omega = w - u dz/dx on interface k of column i [m/s]; zero on the base. The nearest column stands in beyond an end.
  [[nodiscard]] Index omega(int i, int k) const {
    if (k < 1 || k > c_.n_layers) return -1;
    const int column = c_.column(i);
    return start(column) + in_layer(column) * (k - 1) + in_layer(column) - 2;
  }
  /// Pressure in layer k of column i [Pa]; zero above the surface. The nearest column stands in beyond an end.
  [[nodiscard]] Index p(int i, int k) const {
    if (k < 0 || k >= c_.n_layers) return -1;
    const int column = c_.column(i);
    return start(column) + in_layer(column) * k + in_layer(column) - 1;
  }
  /// Thickness of column i [m]; the nearest column stands in beyond an end.
  [[nodiscard]] Index H(int i) const {
    const int column = c_.column(i);
    return start(column) + in_layer(column) * c_.n_layers;
  }
  /// Masses since the start [kg]: poured in, gone over the left end, gone over the right end.
  [[nodiscard]] Index mass_in() const { return budgets_.inflow ? past_columns() + (budgets_.right ? 1 : 0) : -1; }
  [[nodiscard]] Index mass_left() const { return budgets_.left ? 0 : -1; }
  [[nodiscard]] Index mass_right() const { return budgets_.right ? past_columns() : -1; }

  /// Rows: momentum along the layer at (f, k); vertical momentum at interface k >= 1 of column i, paired with the pressure
  /// below it; incompressibility of cell (i, k), paired with the omega above it; kinematics of the surface.
  [[nodiscard]] Index momentum_u(int f, int k) const { return u(f, k); }
  [[nodiscard]] Index momentum_w(int i, int k) const { return p(i, k - 1); }
  [[nodiscard]] Index continuity(int i, int k) const { return omega(i, k + 1); }
  [[nodiscard]] Index surface(int i) const { return H(i); }

 private:
  /// Unknowns of a column in one layer: u at its left face unless that is a wall, omega, p.
  [[nodiscard]] Index in_layer(int column) const { return left_wall_ && column == 0 ? 2 : 3; }
  /// The first number of column i, or of the faces at the far end.
  [[nodiscard]] Index start(int i) const {
    return first_ + Index{i} * (3 * Index{c_.n_layers} + 1) - (left_wall_ && i > 0 ? c_.n_layers : 0);
  }
  [[nodiscard]] Index past_columns() const { return start(c_.n_columns) + (c_.periodic ? 0 : c_.n_layers); }
  grid::Columns c_;
  bool left_wall_;
  Budgets budgets_;
  Index first_;
};

}  // namespace talus::layer
