#include "two_fluid/fall_lines.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "two_fluid/jet_region.hpp"

namespace talus::two_fluid {
namespace {

constexpr int fewest_lines = 4;

/// Number of the interval of ascending nodes that holds x; -1 or the last one's successor outside.
int interval(const std::vector<double>& nodes, double x) {
  return static_cast<int>(std::ranges::upper_bound(nodes, x) - nodes.begin()) - 1;
}

}  // namespace

FallLines fall_lines(const Parameters& par, const grid::Rectilinear& g, const std::function<bool(int, int)>& has_cell) {
  const double angle = par.inflow.along_gravity ? par.box.tilt : 0.0, sine = std::sin(angle), cosine = std::cos(angle);
  const double width = inlet_width(par.inflow);
  double breadth = width;
  for (int i = 0; i < g.n_columns(); ++i) breadth = std::min(breadth, g.dx(i));
  FallLines fall;
  fall.n_lines = std::max(fewest_lines, static_cast<int>(std::ceil(2.0 * width / breadth)));
  for (int line = 0; line < fall.n_lines; ++line) {
    const double x_inlet = par.inflow.position + width * ((line + 0.5) / fall.n_lines - 0.5);
    // Distances from the inlet at which the line passes a node.
    std::vector<double> cuts;
    for (const double z : g.z_nodes) cuts.push_back((par.box.height - z) / cosine);
    const double end = cuts.front();
    if (sine != 0.0)
      for (const double x : g.x_nodes)
        if (const double at = (x - x_inlet) / sine; at > 0.0 && at < end) cuts.push_back(at);
    std::ranges::sort(cuts, std::greater());
    const std::size_t first = fall.steps.size();
    double foot = 0.0;
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      const double middle = 0.5 * (cuts[c] + cuts[c + 1]);
      const int i = interval(g.x_nodes, x_inlet + middle * sine),
                k = interval(g.z_nodes, par.box.height - middle * cosine);
      if (!(cuts[c] > cuts[c + 1]) || !g.has_column(i) || !has_cell(i, k)) continue;
      if (fall.steps.size() == first) foot = cuts[c];
      fall.steps.push_back({line, i, k, foot - cuts[c], foot - cuts[c + 1], middle, false, false});
    }
    if (fall.steps.size() == first) throw std::invalid_argument("two_fluid: what is poured meets no cell");
    fall.steps[first].lowest = fall.steps.back().highest = true;
  }
  return fall;
}

}  // namespace talus::two_fluid
