#pragma once

#include "app/models.hpp"
#include "two_fluid/parameters.hpp"

namespace talus::app {

/// The registry's entry for models/two_fluid.
Model two_fluid_model();

two_fluid::Parameters make_two_fluid_parameters(const Scene& scene);

}  // namespace talus::app
