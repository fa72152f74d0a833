#pragma once

#include "app/models.hpp"
#include "triangle/parameters.hpp"

namespace talus::app {

/// The registry's entry for models/triangle.
Model triangle_model();

triangle::Parameters make_triangle_parameters(const Scene& scene);

}  // namespace talus::app
