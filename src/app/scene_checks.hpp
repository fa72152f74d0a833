#pragma once

#include "app/scene.hpp"
#include "config/problems.hpp"

namespace talus::app {

/// Adds to `problems` what no single key can tell: an inlet outside the box, times out of order, and the like. The
/// scene need not have its law, recording and effective text yet.
void check_together(const Scene& scene, const config::Values& values, config::Problems& problems);

}  // namespace talus::app
