#pragma once

#include "fv/inputs.hpp"
#include "two_fluid/mesh.hpp"

namespace talus::two_fluid {

/// Which budgets a scene needs beside the fields.
struct Budgets {
  bool inflow = false, left = false, right = false, top = false;
  int heaps = 0;  ///< heights of the heap, above which the jet region begins or free fall ends
};

/// Numbers of the unknowns, cell by cell and column by column: u at the cell's left face, w at its upper interface, phi and p in it; w under
/// a cell that has none below, u at a face whose right cell does not exist, in the place of that cell; then budgets and the heap's
/// heights. -1 stands for "not an unknown": it reads as zero, which is what phi and p are in the air outside.
class Unknowns {
 public:
  Unknowns(const Mesh& mesh, Budgets budgets);

  [[nodiscard]] Index size() const { return extra(4) + budgets_.heaps; }
  /// Velocity along x at face f, layer k [m/s]. Below the base minus its mirror image, as grains and air stick to it.
  [[nodiscard]] Index u(int f, int k) const {
    if (!g_->has_face(f) || k >= g_->n_layers()) return -1;
    if (k < 0) return u(f, 0) < 0 ? -1 : fv::minus(u(f, 0));
    return u_[table(g_->face(f), k)];
  }
  /// Velocity along z on interface k of column i [m/s]; none on the base.
  [[nodiscard]] Index w(int i, int k) const {
    return g_->has_column(i) && k > 0 && k <= g_->n_layers() ? w_[table(g_->column(i), k)] : -1;
  }
  /// Volume fraction of the grains [1].
  [[nodiscard]] Index phi(int i, int k) const {
    return g_->has_column(i) && g_->has_layer(k) ? phi_[table(g_->column(i), k)] : -1;
  }
  /// Pressure [Pa].
  [[nodiscard]] Index p(int i, int k) const { return phi(i, k) < 0 ? -1 : phi(i, k) + 1; }
  /// Masses of grains since the start [kg]: poured in, gone over the left end, the right end, through the top or the edge of what they can
  /// reach.
  [[nodiscard]] Index mass_in() const { return budgets_.inflow ? extra(0) : -1; }
  [[nodiscard]] Index mass_left() const { return budgets_.left ? extra(1) : -1; }
  [[nodiscard]] Index mass_right() const { return budgets_.right ? extra(2) : -1; }
  [[nodiscard]] Index mass_top() const { return budgets_.top ? extra(3) : -1; }
  /// Heights of the heap under the jet [m]: one where it is resolved, else one a line of fall.
  [[nodiscard]] int n_heaps() const { return budgets_.heaps; }
  [[nodiscard]] Index heap(int line = 0) const { return line < budgets_.heaps ? extra(4) + line : -1; }

  /// Rows. Momentum along z is paired with the pressure below it and incompressibility with the w above it: no zero diagonal.
  [[nodiscard]] Index momentum_u(int f, int k) const { return k < 0 ? -1 : u(f, k); }
  [[nodiscard]] Index momentum_w(int i, int k) const { return p(i, k - 1) < 0 ? w(i, k) : p(i, k - 1); }
  [[nodiscard]] Index continuity(int i, int k) const { return phi(i, k) < 0 ? -1 : w(i, k + 1); }

 private:
  [[nodiscard]] std::size_t table(int i, int k) const { return static_cast<std::size_t>(i) * (g_->n_layers() + 1) + k; }
  /// The number that follows all fields and the first n budgets that exist.
  [[nodiscard]] Index extra(int n) const {
    const bool exists[] = {budgets_.inflow, budgets_.left, budgets_.right, budgets_.top};
    Index number = n_fields_;
    for (int b = 0; b < n; ++b) number += exists[b] ? 1 : 0;
    return number;
  }

  const grid::Rectilinear* g_;
  Budgets budgets_;
  Index n_fields_ = 0;
  std::vector<Index> u_, w_, phi_;  ///< by `table`
};

}  // namespace talus::two_fluid
