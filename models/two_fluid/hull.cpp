#include "two_fluid/hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace talus::two_fluid {
namespace {

constexpr double anywhere = std::numeric_limits<double>::infinity();

/// Height over the base of a surface of that slope at a distance from its toe, the base sloping down towards it by `tilt` [m].
double face(double distance, double slope, double tilt) {
  const double angle = slope - tilt;
  return angle < 0.5 * std::numbers::pi ? std::max(0.0, distance * std::tan(angle)) : anywhere;
}

}  // namespace

std::vector<bool> reachable_cells(const Parameters& par, const grid::Rectilinear& g, const JetRegion& jet) {
  const Reach& reach = par.numerics.reach;
  const int nx = g.n_columns(), nz = g.n_layers();
  std::vector<bool> reachable(static_cast<std::size_t>(nx) * nz, true);
  if (!reach.limited) return reachable;
  if (!reach.slope || !jet.exists()) throw std::invalid_argument("two_fluid: a limited reach needs a slope and a jet");
  const Box& box = par.box;
  // Of a cell its lowest point towards the hull.
  const auto under_faces = [&](int i, int k) {
    const double right = box.right_open ? face(box.length - g.x_nodes[i], *reach.slope, box.tilt) : anywhere;
    const double left = box.left_open ? face(g.x_nodes[i + 1], *reach.slope, -box.tilt) : anywhere;
    return g.z_nodes[k] < std::min(left, right) + reach.margin;
  };
  const auto near_jet = [&](int i, int k, double margin) {
    return jet.comes_near(g.x_centre(i), g.z_centre(k), g.dx(i), g.dz(k), margin);
  };
  double highest = -anywhere;
  for (int i = 0; i < nx; ++i)
    for (int k = 0; k < nz; ++k)
      if (near_jet(i, k, 0.0) && under_faces(i, k))
        highest = std::max(highest, jet.height(g.x_centre(i), g.z_centre(k)));
  for (int i = 0; i < nx; ++i) {
    for (int k = 0; k < nz; ++k) {
      const double lowest =
          std::min(jet.height(g.x_nodes[i], g.z_nodes[k]), jet.height(g.x_nodes[i + 1], g.z_nodes[k]));
      const bool in_hull = under_faces(i, k) && lowest < highest + reach.margin;
      const bool at_start = g.z_nodes[k] < par.thickness + reach.margin;
      const bool in_jet = par.numerics.jet == Jet::resolved && near_jet(i, k, reach.margin);
      reachable[static_cast<std::size_t>(i) * nz + k] = in_hull || at_start || in_jet;
    }
  }
  return reachable;
}

}  // namespace talus::two_fluid
