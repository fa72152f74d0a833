#pragma once

#include <vector>

#include "app/scene.hpp"
#include "column/column.hpp"

namespace talus::app {

/// Why a scene's layer is not uniform: has ends, a lid, an inflow, a base that moves, slips or leans; "" where it is.
std::string why_not_uniform(const Scene& scene);

/// The scene's layer at rest, undisturbed, in the box as it stands at the end, for good. Throws core::ConfigError for another model than
/// layer or column and for a layer that is not uniform.
Scene uniform_layer_at_rest(const Scene& scene);

/// Speeds of the discrete steady state on the column's layers, from the base up [m/s], by KINSOL. Throws core::IntegrationError where there is
/// none to be found.
std::vector<double> steady_speeds(const column::Column& column, const Scene& scene);

}  // namespace talus::app
