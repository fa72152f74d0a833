#include "two_fluid/mesh.hpp"

#include <algorithm>
#include <stdexcept>

#include "two_fluid/hull.hpp"

namespace talus::two_fluid {
namespace {

grid::Rectilinear make_grid(const Parameters& par) {
  if (par.grid.columns < 1 || par.grid.layers < 2)
    throw std::invalid_argument("two_fluid: needs a column and two layers");
  return {grid::geometric_nodes(par.grid.columns, par.box.length, par.grid.x_ratio),
          grid::geometric_nodes(par.grid.layers, par.box.height, par.grid.z_ratio), par.box.periodic};
}

}  // namespace

Mesh::Mesh(const Parameters& par)
    : grid_(make_grid(par)),
      jet_(par),
      transport_(par.numerics.transport),
      settles_(par.numerics.direction == Direction::settling),
      giver_is_left_(par.box.tilt > 0.0),
      left_wall_(!par.box.left_open),
      right_wall_(!par.box.right_open),
      exists_(reachable_cells(par, grid_, jet_)) {
  const int nx = grid_.n_columns(), nz = grid_.n_layers();
  for (int i = 0; i < nx; ++i)
    for (int k = 0; k < nz; ++k) inner_.push_back(lies_inside(i, k));
  if (par.inflow.rate > 0.0 && par.numerics.jet == Jet::free_fall)
    fall_ = fall_lines(par, grid_, [&](int i, int k) { return has_cell(i, k); });
  else if (par.inflow.rate > 0.0) {
    const double from = par.inflow.position - 0.5 * inlet_width(par.inflow), to = from + inlet_width(par.inflow);
    for (int i = 0; i < nx; ++i) {
      const double overlap = std::min(to, grid_.x_nodes[i + 1]) - std::max(from, grid_.x_nodes[i]);
      inlet_.push_back(std::max(overlap, 0.0) / grid_.dx(i));
    }
  }
  for (int i = 0; i < nx; ++i) {
    for (int k = 0; k < nz; ++k) {
      if (has_cell(i, k)) cells_.push_back({i, k});
      if (has_interface(i, k + 1)) interfaces_.push_back({i, k + 1});
    }
  }
  for (int f = 0; f < grid_.n_faces(); ++f) {
    if (is_on_base(f, 0)) base_.push_back({f, 0});
    for (int k = 0; k < nz; ++k) {
      if (has_face(f, k)) faces_.push_back({f, k});
      if (is_amid(f, k)) corners_.push_back({f, k});
    }
    if (inlet_share(f - 1) > 0.0 || inlet_share(f) > 0.0) inlet_corners_.push_back({f, nz});
  }
}

/// Whether all cells that any term about the lower left corner, face or interface of a cell reads exist, are as high, and lie away from the
/// jet region.
bool Mesh::lies_inside(int i, int k) const {
  constexpr int before = 2, after = 2;
  for (int di = -before; di <= after; ++di) {
    for (int dk = -before; dk <= after; ++dk) {
      if (!grid_.has_column(i + di) || !has_cell(i + di, k + dk) || grid_.dz(k + dk) != grid_.dz(k)) return false;
      const int column = grid_.column(i + di);
      if (jet_.in_corridor(grid_.x_nodes[column], grid_.z_centre(k + dk)) ||
          jet_.in_corridor(grid_.x_centre(column), grid_.z_nodes[k + dk]))
        return false;
    }
  }
  return true;
}

}  // namespace talus::two_fluid
