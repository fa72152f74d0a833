#pragma once

#include <string>

#include "app/scene.hpp"

namespace talus::app {

/// What `talus check` prints: size, expected memory, what theory says of the steady state, and warnings.
std::string check_report(const Scene& scene);

/// Resident memory [byte] that a run of a system of n unknowns and `n_nonzeros` Jacobian entries is expected to need, mostly the
/// factors of the Jacobian. Fitted to measured runs, see the README; half as much again is possible.
double expected_memory(double n, double n_nonzeros);

}  // namespace talus::app
