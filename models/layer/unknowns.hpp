#pragma once

#include "fv/inputs.hpp"
#include "grid/columns.hpp"

namespace talus::layer {

using grid::Index;

/// Which budgets a scene needs beside the fields of the layer.
struct Budgets {
  bool inflow = false;  ///< mass poured in
  bool left = false;    ///< mass that left over the left end
  bool right = false;   ///< mass that left over the right end
};

/// What bounds the columns, as far as it takes unknowns away.
struct Edges {
  bool left_wall = false, right_wall = false;
  bool no_slip = false;  ///< the grains stick to these walls
  bool lid = false;      ///< the surface is held
};

/// Numbers of the unknowns, column by column, and of the equation rows that carry the same numbers.
/// Column i owns, for each layer from the base up, u at its left face, omega at the layer's upper interface and p in the
/// cell; then its thickness H. The faces at the far end follow. Budgets stand beside the end whose flux they sum, so that the
/// Jacobian stays a narrow band. A wall has no u, a lid no omega. -1 stands for "not an unknown": it reads as zero.
///
/// Under a lid the box is closed: the volumes of its cells hang together, and pressure is known up to a constant. The row of
/// incompressibility of the last column's top cell, which follows from all others, makes way for one that sets the level of
/// pressure.
class Unknowns {
 public:
  Unknowns(const grid::Columns& columns, const Edges& edges, Budgets budgets)
      : c_(columns),
        edges_(edges),
        left_wall_(edges.left_wall && !columns.periodic),
        right_wall_(edges.right_wall && !columns.periodic),
        budgets_(budgets),
        first_(budgets.left ? 1 : 0) {}

  [[nodiscard]] Index size() const { return past_columns() + (budgets_.right ? 1 : 0) + (budgets_.inflow ? 1 : 0); }
  /// Velocity along x at face f, layer k [m/s]; zero at a wall.
  [[nodiscard]] Index u(int f, int k) const {
    if (k < 0 || k >= c_.n_layers || !c_.has_face(f) || is_wall(f)) return -1;
    const int face = c_.face(f);
    return start(face) + (face == c_.n_columns ? k : 3 * k);
  }
  /// omega = w - u dz/dx on interface k of column i [m/s]; zero on the base and the lid. The nearest column stands in beyond an
  /// end; beyond a wall to which grains stick it does so with the opposite sign.
  [[nodiscard]] Index omega(int i, int k) const {
    if (k < 1 || k > c_.n_layers - at_lid()) return -1;
    const int column = c_.column(i);
    const Index number = start(column) + in_layer(column) * (k - 1) + in_layer(column) - 2;
    const bool beyond_wall = (left_wall_ && i < 0) || (right_wall_ && i >= c_.n_columns);
    return beyond_wall && edges_.no_slip ? fv::minus(number) : number;
  }
  /// Pressure in layer k of column i [Pa]; zero above the surface. The nearest column stands in beyond an end.
  [[nodiscard]] Index p(int i, int k) const {
    if (k < 0 || k >= c_.n_layers) return -1;
    const int column = c_.column(i);
    return start(column) + in_layer(column) * k + in_layer(column) - 1 - (k == c_.n_layers - 1 ? at_lid() : 0);
  }
  /// Thickness of column i [m]; the nearest column stands in beyond an end.
  [[nodiscard]] Index H(int i) const {
    const int column = c_.column(i);
    return start(column) + in_layer(column) * c_.n_layers - at_lid();
  }
  /// Masses since the start [kg]: poured in, gone over the left end, gone over the right end.
  [[nodiscard]] Index mass_in() const { return budgets_.inflow ? past_columns() + (budgets_.right ? 1 : 0) : -1; }
  [[nodiscard]] Index mass_left() const { return budgets_.left ? 0 : -1; }
  [[nodiscard]] Index mass_right() const { return budgets_.right ? past_columns() : -1; }

  /// Rows: momentum along the layer at (f, k); vertical momentum at interface k >= 1 of column i, paired with the pressure
  /// below it; incompressibility of cell (i, k), paired with the omega above it, or under a lid with its pressure; kinematics
  /// of the surface, or the height of the lid; level of pressure under a lid. -1 where there is none.
  [[nodiscard]] Index momentum_u(int f, int k) const { return u(f, k); }
  [[nodiscard]] Index momentum_w(int i, int k) const { return edges_.lid && k == c_.n_layers ? -1 : p(i, k - 1); }
  [[nodiscard]] Index continuity(int i, int k) const {
    if (!edges_.lid || k < c_.n_layers - 1) return omega(i, k + 1);
    return c_.column(i) == c_.n_columns - 1 ? -1 : p(i, k);
  }
  [[nodiscard]] Index surface(int i) const { return edges_.lid ? -1 : H(i); }
  [[nodiscard]] Index lid(int i) const { return edges_.lid ? H(i) : -1; }
  [[nodiscard]] Index pressure_level() const { return edges_.lid ? p(c_.n_columns - 1, c_.n_layers - 1) : -1; }

 private:
  /// Unknowns of a column in one layer: u at its left face unless that is a wall, omega, p.
  [[nodiscard]] Index in_layer(int column) const { return left_wall_ && column == 0 ? 2 : 3; }
  /// The first number of column i, or of the faces at the far end.
  [[nodiscard]] Index start(int i) const {
    return first_ + Index{i} * (3 * Index{c_.n_layers} + 1 - at_lid()) - (left_wall_ && i > 0 ? c_.n_layers : 0);
  }
  [[nodiscard]] Index past_columns() const {
    return start(c_.n_columns) + (c_.periodic || right_wall_ ? 0 : c_.n_layers);
  }
  [[nodiscard]] bool is_wall(int f) const { return (left_wall_ && f == 0) || (right_wall_ && f == c_.n_columns); }
  /// How many omegas a lid takes from a column.
  [[nodiscard]] int at_lid() const { return edges_.lid ? 1 : 0; }
  grid::Columns c_;
  Edges edges_;
  bool left_wall_, right_wall_;
  Budgets budgets_;
  Index first_;
};

}  // namespace talus::layer
