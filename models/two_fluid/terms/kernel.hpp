#pragma once

#include <array>

#include "fv/term.hpp"
#include "two_fluid/context.hpp"
#include "two_fluid/unknowns.hpp"

namespace talus::two_fluid {

/// What every kernel has: the mesh, the numbers of the unknowns, and the places at which it acts. All outlive it.
struct Kernel {
  static constexpr bool uses_rate = false;
  const Mesh* mesh;
  const Unknowns* at;
  const std::vector<Place>* places;

  [[nodiscard]] Index n_places() const { return static_cast<Index>(places->size()); }
  [[nodiscard]] Place place(Index number) const { return (*places)[static_cast<std::size_t>(number)]; }
  [[nodiscard]] const grid::Rectilinear& grid() const { return mesh->grid(); }

  /// How many places from this one on, up a column, go the same way through the code.
  [[nodiscard]] Index alike(Index number) const {
    const auto [i, k] = place(number);
    Index n = 1;
    if (!mesh->is_inside(i, k)) return n;
    while (number + n < n_places() && place(number + n).i == i && place(number + n).k == k + n &&
           mesh->is_inside(i, static_cast<int>(k + n)))
      ++n;
    return n;
  }
  /// Volume of the cell (i, k) that belongs to the momentum volume of a face or interface beside it [m2]; 0 for no cell.
  [[nodiscard]] double half_cell(int i, int k) const {
    return mesh->has_cell(i, k) ? 0.5 * grid().dx(i) * grid().dz(k) : 0.0;
  }
  /// The heap's height, where the jet region's edge can pass the face (f, k) or the interface (i, k); else no input.
  [[nodiscard]] Index heap_at_face(int f, int k) const {
    return mesh->jet().in_corridor(grid().x_nodes[grid().face(f)], grid().z_centre(k)) ? at->heap() : -1;
  }
  [[nodiscard]] Index heap_at_interface(int i, int k) const {
    return mesh->jet().in_corridor(grid().x_centre(grid().column(i)), grid().z_nodes[k]) ? at->heap() : -1;
  }
  /// phi of the cell (i, k), two from the face (f, k), or of the cell (i, layer), two from the interface (i, k): where the flux of grains
  /// there reads it.
  [[nodiscard]] Index far_phi_at_face(int f, int k, int i) const {
    return mesh->limits_at(grid().x_nodes[grid().face(f)], grid().z_centre(k)) ? at->phi(i, k) : -1;
  }
  [[nodiscard]] Index far_phi_at_interface(int i, int k, int layer) const {
    return mesh->limits_at(grid().x_centre(grid().column(i)), grid().z_nodes[k]) ? at->phi(i, layer) : -1;
  }
  /// phi beneath the cell that gives grains along the base through the face (f, k), where the flux there reads it.
  [[nodiscard]] Index beneath_at_face(int f, int k) const {
    const auto [i, layer] = mesh->beneath_giver(f, k);
    return at->phi(i, layer);
  }
  /// phi of the four cells in a row that the flux of grains reads at the face (f, k) or the interface (i, k).
  [[nodiscard]] std::array<Index, 4> row_at_face(int f, int k) const {
    return {far_phi_at_face(f, k, f - 2), at->phi(f - 1, k), at->phi(f, k), far_phi_at_face(f, k, f + 1)};
  }
  [[nodiscard]] std::array<Index, 4> row_at_interface(int i, int k) const {
    return {far_phi_at_interface(i, k, k - 2), at->phi(i, k - 1), at->phi(i, k), far_phi_at_interface(i, k, k + 1)};
  }
};

}  // namespace talus::two_fluid
