#pragma once

#include "app/models.hpp"
#include "layer/parameters.hpp"

namespace talus::app {

/// The registry's entry for models/layer.
Model layer_model();

layer::Parameters make_layer_parameters(const Scene& scene);

}  // namespace talus::app
