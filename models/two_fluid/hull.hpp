#pragma once

#include <vector>

#include "grid/rectilinear.hpp"
#include "two_fluid/jet_region.hpp"

namespace talus::two_fluid {

/// Whether grains can come to each cell, shape columns by layers: all of the box, or where Parameters::numerics.reach is limited what the
/// lies no more than the margin beside the jet's corridor or above the hull of any heap. The hull descends from the jet: not below the
/// lines of its slope through the open ends of the base, not above a level line through its own highest point in the corridor. Grains
/// that lie there at the start are in it. Throws std::invalid_argument where a limited reach has no slope or no jet.
std::vector<bool> reachable_cells(const Parameters& parameters, const grid::Rectilinear& grid, const JetRegion& jet);

}  // namespace talus::two_fluid
