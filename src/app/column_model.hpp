#pragma once

#include "app/models.hpp"
#include "column/parameters.hpp"

namespace talus::app {

/// The registry's entry for models/column.
Model column_model();

column::Parameters make_column_parameters(const Scene& scene);

}  // namespace talus::app
