#pragma once

#include <vector>

#include "grid/rectilinear.hpp"
#include "two_fluid/fall_lines.hpp"
#include "two_fluid/jet_region.hpp"

namespace talus::two_fluid {

using grid::Index;

/// A place on the grid: column or face, layer or interface.
struct Place {
  int i, k;
};

/// The cells that have unknowns, and the places at which terms act. Beyond the outermost cells, base aside, lies still air at no pressure:
/// the edge of what grains can reach is as open as the ends of the box.
class Mesh {
 public:
  /// Throws std::invalid_argument where the grid has no cell.
  explicit Mesh(const Parameters& parameters);

  [[nodiscard]] const grid::Rectilinear& grid() const { return grid_; }
  [[nodiscard]] const JetRegion& jet() const { return jet_; }
  /// Of grains in free fall; none where the jet is resolved.
  [[nodiscard]] const FallLines& fall() const { return fall_; }
  /// Whether the flux of grains at (x, z) may be of second order, so that it reads cells that are not beside it.
  [[nodiscard]] bool limits_at(double x, double z) const {
    return transport_ == Transport::limited || (transport_ == Transport::jet && jet_.in_corridor(x, z));
  }
  /// Where grains settle, the cell beneath the one that gives them through the face (f, k) along the base; else no cell.
  [[nodiscard]] Place beneath_giver(int f, int k) const { return {giver_is_left_ ? f - 1 : f, settles_ ? k - 1 : -1}; }
  [[nodiscard]] bool has_cell(int i, int k) const {
    return grid_.has_column(i) && grid_.has_layer(k) && exists_[number(i, k)];
  }
  /// Face f of layer k, interface k > 0 of column i: beside a cell.
  [[nodiscard]] bool has_face(int f, int k) const { return has_cell(f - 1, k) || has_cell(f, k); }
  [[nodiscard]] bool has_interface(int i, int k) const { return k > 0 && (has_cell(i, k - 1) || has_cell(i, k)); }
  /// A corner amid four cells: shear is transmitted there.
  [[nodiscard]] bool is_amid(int f, int k) const {
    return has_cell(f - 1, k - 1) && has_cell(f, k - 1) && has_cell(f - 1, k) && has_cell(f, k);
  }
  /// A corner on the base amid two cells, or at an open end.
  [[nodiscard]] bool is_on_base(int f, int k) const { return k == 0 && has_face(f, 0); }
  /// Share of the top of column i through which grains are poured [1].
  [[nodiscard]] double inlet_share(int i) const { return inlet_.empty() ? 0.0 : inlet_[grid_.column(i)]; }
  [[nodiscard]] bool is_inlet(int i, int k) const { return k == grid_.n_layers() && inlet_share(i) > 0.0; }
  /// A wall: nothing passes.
  [[nodiscard]] bool is_wall(int f) const {
    return !grid_.periodic && ((f == 0 && left_wall_) || (f == grid_.n_columns() && right_wall_));
  }

  /// Whether terms at cell (i, k), at its left face, its lower interface and its lower left corner go the same way through their code as
  /// one layer higher or lower, where that is inside, too.
  [[nodiscard]] bool is_inside(int i, int k) const {
    return grid_.has_column(i) && grid_.has_layer(k) && inner_[number(i, k)];
  }

  [[nodiscard]] const std::vector<Place>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<Place>& faces() const { return faces_; }            ///< of columns: where u is
  [[nodiscard]] const std::vector<Place>& interfaces() const { return interfaces_; }  ///< above the base: where w is
  [[nodiscard]] const std::vector<Place>& corners() const { return corners_; }        ///< amid four cells
  [[nodiscard]] const std::vector<Place>& base() const { return base_; }              ///< corners on the base
  [[nodiscard]] const std::vector<Place>& inlet_corners() const { return inlet_corners_; }

 private:
  [[nodiscard]] bool lies_inside(int i, int k) const;
  [[nodiscard]] std::size_t number(int i, int k) const {
    return static_cast<std::size_t>(grid_.column(i)) * grid_.n_layers() + k;
  }

  grid::Rectilinear grid_;
  JetRegion jet_;
  FallLines fall_;
  Transport transport_;
  bool settles_, giver_is_left_;
  bool left_wall_, right_wall_;
  std::vector<bool> exists_, inner_;  ///< each cell, column by column
  std::vector<double> inlet_;
  std::vector<Place> cells_, faces_, interfaces_, corners_, base_, inlet_corners_;
};

}  // namespace talus::two_fluid
