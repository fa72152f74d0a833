#pragma once

#include "fv/inputs.hpp"
#include "two_fluid/mesh.hpp"

namespace talus::two_fluid {

/// Which budgets a scene needs beside the fields.
struct Budgets {
  bool inflow = false, left = false, right = false, top = false;
  bool heap = false;  ///< the heap's highest point, above which the jet region begins
};

/// Numbers of the unknowns, cell by cell and column by column: u at the cell's left face, w at its upper interface, phi and p in it;
/// then u at the far end, budgets, the heap's highest point. -1 stands for "not an unknown": it reads as zero, which is what phi and p
/// are in the air outside.
class Unknowns {
 public:
  Unknowns(const grid::Rectilinear& grid, Budgets budgets) : g_(&grid), budgets_(budgets) {}

  [[nodiscard]] Index size() const { return extra(5); }
  /// Velocity along x at face f, layer k [m/s]. Below the base minus its mirror image, as grains and air stick to it.
  [[nodiscard]] Index u(int f, int k) const {
    if (!g_->has_face(f) || k >= g_->n_layers()) return -1;
    if (k < 0) return fv::minus(u(f, 0));
    const int face = g_->face(f);
    return face < g_->n_columns() ? cell(face, k) : n_cells() * 4 + k;
  }
  /// Velocity along z on interface k of column i [m/s]; none on the base.
  [[nodiscard]] Index w(int i, int k) const {
    return g_->has_column(i) && k > 0 && k <= g_->n_layers() ? cell(g_->column(i), k - 1) + 1 : -1;
  }
  /// Volume fraction of the grains [1].
  [[nodiscard]] Index phi(int i, int k) const { return has(i, k) ? cell(g_->column(i), k) + 2 : -1; }
  /// Pressure [Pa].
  [[nodiscard]] Index p(int i, int k) const { return has(i, k) ? cell(g_->column(i), k) + 3 : -1; }
  /// Masses of grains since the start [kg]: poured in, gone over the left end, the right end, the top.
  [[nodiscard]] Index mass_in() const { return budgets_.inflow ? extra(0) : -1; }
  [[nodiscard]] Index mass_left() const { return budgets_.left ? extra(1) : -1; }
  [[nodiscard]] Index mass_right() const { return budgets_.right ? extra(2) : -1; }
  [[nodiscard]] Index mass_top() const { return budgets_.top ? extra(3) : -1; }
  /// Height of the heap under the jet [m].
  [[nodiscard]] Index heap() const { return budgets_.heap ? extra(4) : -1; }

  /// Rows. Momentum along z is paired with the pressure below it and incompressibility with the w above it: no zero diagonal.
  [[nodiscard]] Index momentum_u(int f, int k) const { return k < 0 ? -1 : u(f, k); }
  [[nodiscard]] Index momentum_w(int i, int k) const { return p(i, k - 1); }
  [[nodiscard]] Index continuity(int i, int k) const { return has(i, k) ? w(i, k + 1) : -1; }

 private:
  [[nodiscard]] bool has(int i, int k) const { return g_->has_column(i) && g_->has_layer(k); }
  [[nodiscard]] Index n_cells() const { return Index{g_->n_columns()} * g_->n_layers(); }
  [[nodiscard]] Index cell(int i, int k) const { return 4 * (Index{i} * g_->n_layers() + k); }
  /// The number that follows all fields and the first n budgets that exist.
  [[nodiscard]] Index extra(int n) const {
    const bool exists[] = {budgets_.inflow, budgets_.left, budgets_.right, budgets_.top, budgets_.heap};
    Index number = 4 * n_cells() + (g_->periodic ? 0 : g_->n_layers());
    for (int b = 0; b < n; ++b) number += exists[b] ? 1 : 0;
    return number;
  }

  const grid::Rectilinear* g_;
  Budgets budgets_;
};

}  // namespace talus::two_fluid
