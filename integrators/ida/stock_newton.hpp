#pragma once

#include <sundials/sundials_nonlinearsolver.h>

#include "bridge/equations.hpp"
#include "bridge/linear_shell.hpp"
#include "bridge/vectors.hpp"

namespace talus::ida {

using bridge::Equations;
using bridge::view;

/// SUNDIALS' own Newton iteration over our Jacobian and direct solver, for comparison with StepNewton.
class StockNewton {
 public:
  /// Attaches itself to `ida_memory`, whose user data must be `equations`. Throws std::runtime_error.
  StockNewton(Equations& equations, void* ida_memory, N_Vector shape, SUNContext context);
  StockNewton(const StockNewton&) = delete;
  StockNewton& operator=(const StockNewton&) = delete;
  ~StockNewton();

 private:
  SUNNonlinearSolver newton_;
  bridge::LinearShell linear_;
};

}  // namespace talus::ida
