#pragma once

#include "linear/direct_solver.hpp"

namespace talus::ida {

/// `damped` is ours (DampedNewton); `stock` is SUNDIALS' own, with a frozen Jacobian and no damping, for comparison.
enum class Newton { damped, stock };

struct NewtonOptions {
  Newton kind = Newton::damped;
  double tolerance = 0.03;       ///< estimated remaining error, in the weighted norm, at which the iteration stops
  double refresh_above = 0.7;    ///< contraction above which a move is slow
  int slow_moves = 2;            ///< in one solve, after which the Jacobian is renewed
  double growth = 1.5;           ///< of the correction, that is accepted while the Jacobian is stale
  int depth = 5;                 ///< of the acceleration: secants that are kept
  int max_refreshes = 20;        ///< of the Jacobian in one solve
  int max_halvings = 12;         ///< of the step length in one iteration
  int max_iterations = 100;      ///< in one solve
  double residual_share = 0.01;  ///< of the residual at the start of a solve, that may be left in doubt
  int doubt = 10;                ///< solves in doubt after a start and after a step that had to be shortened
};

/// How IDA is run. Weighted norm: root mean square of v_i / (rtol |y_i| + absolute tolerance of the field).
struct Options {
  double rtol = 1e-4;              ///< relative tolerance of the error test
  int max_order = 5;               ///< of the backward differentiation formula, 1 to 5
  double initial_step = 0.0;       ///< [s]; 0: IDA's choice
  double max_step = 0.0;           ///< [s]; 0: none
  double min_step = 1e-12;         ///< [s]; a step that must be cut below ends the run
  bool suppress_algebraic = true;  ///< leave algebraic unknowns out of the error test (index 2 needs it)
  double start_step = 1e-7;        ///< [s] of the two implicit Euler steps that make a start consistent
  int max_failures_in_a_row = 10;  ///< of Newton's method, and of the error test, in one step
  long max_steps_between_outputs = 50000;
  long max_failures_between_outputs = 1000;  ///< Newton and error test together: guards against a crawl
  NewtonOptions newton;
  linear::Settings linear = {.accuracy = 1e-6};  ///< corrections contract: they need no more digits
};

}  // namespace talus::ida
