#include "bridge/linear_shell.hpp"

#include <new>

#include "bridge/vectors.hpp"

namespace talus::bridge {
namespace {

/// Of SUNDIALS' own flags: it takes any other number for success.
int solver_flag(Outcome outcome) {
  if (outcome == Outcome::ok) return SUNLS_SUCCESS;
  return outcome == Outcome::refused ? SUNLS_PACKAGE_FAIL_REC : SUNLS_PACKAGE_FAIL_UNREC;
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
    return solver_flag(static_cast<Equations*>(self->content)->solve(view(x)));
  };
  return solver;
}

}  // namespace

LinearShell::LinearShell(Equations& equations, SUNContext context)
    : solver_(make_solver(equations, context)), matrix_(make_matrix(context)) {}

LinearShell::~LinearShell() {
  SUNLinSolFreeEmpty(solver_);
  SUNMatFreeEmpty(matrix_);
}

}  // namespace talus::bridge
