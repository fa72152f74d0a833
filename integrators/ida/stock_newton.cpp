#include "ida/stock_newton.hpp"

#include <ida/ida.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <stdexcept>

namespace talus::ida {
namespace {

/// A callback's return value: positive asks IDA for a smaller step, negative ends the integration.
int flag(Outcome outcome) { return outcome == Outcome::ok ? 0 : (outcome == Outcome::refused ? 1 : -1); }

int refresh(realtype t, realtype c_j, N_Vector y, N_Vector yp, N_Vector, SUNMatrix, void* user, N_Vector, N_Vector,
            N_Vector) {
  return flag(static_cast<Equations*>(user)->refresh(t, view(y), view(yp), c_j));
}

SUNMatrix make_matrix(SUNContext context) {
  SUNMatrix matrix = SUNMatNewEmpty(context);
  if (matrix == nullptr) throw std::bad_alloc();
  matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  matrix->ops->zero = [](SUNMatrix) { return 0; };
  return matrix;
}

SUNLinearSolver make_solver(Equations& equations, SUNContext context) {
  SUNLinearSolver solver = SUNLinSolNewEmpty(context);
  if (solver == nullptr) throw std::bad_alloc();
  solver->content = &equations;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->setup = [](SUNLinearSolver, SUNMatrix) { return 0; };  // factored together with the Jacobian
  solver->ops->solve = [](SUNLinearSolver self, SUNMatrix, N_Vector x, N_Vector b, realtype) {
    N_VScale(1.0, b, x);
    return flag(static_cast<Equations*>(self->content)->solve(view(x)));
  };
  return solver;
}

}  // namespace

StockNewton::StockNewton(Equations& equations, void* ida_memory, N_Vector shape, SUNContext context)
    : newton_(SUNNonlinSol_Newton(shape, context)),
      solver_(make_solver(equations, context)),
      matrix_(make_matrix(context)) {
  if (IDASetNonlinearSolver(ida_memory, newton_) != IDA_SUCCESS ||
      IDASetLinearSolver(ida_memory, solver_, matrix_) != IDA_SUCCESS ||
      IDASetJacFn(ida_memory, refresh) != IDA_SUCCESS) {
    throw std::runtime_error("IDA does not accept the stock Newton solver");
  }
}

StockNewton::~StockNewton() {
  SUNNonlinSolFree(newton_);
  SUNLinSolFreeEmpty(solver_);
  SUNMatFreeEmpty(matrix_);
}

}  // namespace talus::ida
