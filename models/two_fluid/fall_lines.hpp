#pragma once

#include <functional>
#include <vector>

#include "grid/rectilinear.hpp"
#include "two_fluid/parameters.hpp"

namespace talus::two_fluid {

/// What a line of fall has of one cell.
struct FallStep {
  int line, i, k;
  double from, to;       ///< along the line, upwards from the lowest cell that it passes [m]
  double drop;           ///< of its middle below the inlet, along the line [m]
  bool lowest, highest;  ///< of its line
};

/// The straight lines along gravity on which grains fall from the inlet, an equal share of them on each.
struct FallLines {
  int n_lines = 0;
  std::vector<FallStep> steps;  ///< line by line, upwards
};

/// Lines from the inlet through the cells that exist, two or more to a cell's breadth. Throws std::invalid_argument where one meets no cell.
FallLines fall_lines(const Parameters& par, const grid::Rectilinear& g, const std::function<bool(int, int)>& has_cell);

}  // namespace talus::two_fluid
