#pragma once

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>

#include "ida/equations.hpp"
#include "ida/vectors.hpp"

namespace talus::ida {

/// SUNDIALS' own Newton iteration over our Jacobian and direct solver, for comparison with StepNewton. SUNDIALS' matrix
/// object is an empty shell: Jacobian and factors live in Equations.
class StockNewton {
 public:
  /// Attaches itself to `ida_memory`, whose user data must be `equations`. Throws std::runtime_error.
  StockNewton(Equations& equations, void* ida_memory, N_Vector shape, SUNContext context);
  StockNewton(const StockNewton&) = delete;
  StockNewton& operator=(const StockNewton&) = delete;
  ~StockNewton();

 private:
  SUNNonlinearSolver newton_;
  SUNLinearSolver solver_;
  SUNMatrix matrix_;
};

}  // namespace talus::ida
