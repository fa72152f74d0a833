#pragma once

#include <cstdint>

namespace talus::core {

/// Counters and CPU time of an integration since its start; restarts included.
struct Statistics {
  std::int64_t steps = 0;
  std::int64_t error_test_failures = 0;
  std::int64_t newton_failures = 0;
  std::int64_t newton_iterations = 0;
  std::int64_t residuals = 0;
  std::int64_t jacobians = 0;
  std::int64_t factorisations = 0;
  std::int64_t solves = 0;
  std::int64_t inadmissible_states = 0;  ///< residual calls refused by the model
  std::int64_t restarts = 0;             ///< starts afresh at breakpoints and checkpoints; of steady solves: continuation steps
  int order = 0;                         ///< of the last step
  double last_step = 0.0;                ///< [s]
  double seconds_residual = 0.0;         ///< CPU [s]
  double seconds_jacobian = 0.0;
  double seconds_factor = 0.0;
  double seconds_solve = 0.0;
};

}  // namespace talus::core
