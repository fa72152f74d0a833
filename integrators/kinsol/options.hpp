#pragma once

#include "linear/direct_solver.hpp"

namespace talus::kinsol {

/// The way round a Newton iteration that does not converge: implicit Euler steps of growing size.
struct ContinuationOptions {
  bool allowed = true;
  double first_step = 1.0;     ///< [s], cut until a step converges
  double growth = 10.0;        ///< of the step, after each that converged at once
  double least_step = 1e-12;   ///< [s]; a step that must be cut below ends the search
  double settled_below = 0.1;  ///< relative change in a step below which the steady state is tried
  int max_steps = 300;         ///< accepted and failed together
  int max_iterations = 30;     ///< of Newton's method, in one step
};

/// How a steady state is sought. An unknown's weight is rtol |y_i| + the absolute tolerance of its field.
struct Options {
  double rtol = 1e-4;
  double tolerance = 1e-3;   ///< largest last correction of Newton's method, in weights
  int max_iterations = 200;  ///< of Newton's method, in one solve without continuation
  ContinuationOptions continuation;
  linear::Settings linear;
};

}  // namespace talus::kinsol
