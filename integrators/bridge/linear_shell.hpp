#pragma once

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include "bridge/equations.hpp"

namespace talus::bridge {

/// What SUNDIALS wants to see of a matrix and of a direct solver: empty shells. Jacobian and factors live in Equations,
/// where a Jacobian is factored as soon as it is made; set-up does nothing, solve is Equations::solve.
class LinearShell {
 public:
  /// `equations` must outlive this.
  LinearShell(Equations& equations, SUNContext context);
  LinearShell(const LinearShell&) = delete;
  LinearShell& operator=(const LinearShell&) = delete;
  ~LinearShell();

  [[nodiscard]] SUNLinearSolver solver() const { return solver_; }
  [[nodiscard]] SUNMatrix matrix() const { return matrix_; }

 private:
  SUNLinearSolver solver_;
  SUNMatrix matrix_;
};

}  // namespace talus::bridge
