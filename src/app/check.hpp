#pragma once

#include <string>

#include "app/scene.hpp"
#include "core/sparse_pattern.hpp"

namespace talus::app {

/// What `talus check` prints: size, expected memory, what theory says of the steady state, and warnings.
std::string check_report(const Scene& scene);

/// Resident memory [byte] that a run with a Jacobian of this pattern is expected to need at most: grows with the
/// unknowns times the mean distance of an entry from the diagonal, as banded factors do. Fitted to three runs, see the README.
double expected_memory(const core::SparsePattern& pattern);

}  // namespace talus::app
