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
  std::int64_t restarts = 0;  ///< starts afresh at breakpoints and checkpoints; of steady solves: continuation steps
  int order = 0;              ///< of the last step
  double last_step = 0.0;     ///< [s]
  double seconds_residual = 0.0;  ///< CPU [s]
  double seconds_jacobian = 0.0;
  double seconds_factor = 0.0;
  double seconds_solve = 0.0;
};

/// Calls visit(name, value) for each member of a Statistics, const or not; CPU times under cpu_<part>.
template <class S, class Visit>
void for_each_counter(S& s, Visit&& visit) {
  visit("steps", s.steps);
  visit("error_test_failures", s.error_test_failures);
  visit("newton_failures", s.newton_failures);
  visit("newton_iterations", s.newton_iterations);
  visit("residuals", s.residuals);
  visit("jacobians", s.jacobians);
  visit("factorisations", s.factorisations);
  visit("solves", s.solves);
  visit("inadmissible_states", s.inadmissible_states);
  visit("restarts", s.restarts);
  visit("order", s.order);
  visit("last_step", s.last_step);
  visit("cpu_residual", s.seconds_residual);
  visit("cpu_jacobian", s.seconds_jacobian);
  visit("cpu_factor", s.seconds_factor);
  visit("cpu_solve", s.seconds_solve);
}

}  // namespace talus::core
