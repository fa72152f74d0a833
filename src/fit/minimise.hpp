#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/problem.hpp"

namespace talus::fit {

/// A sum of squares between bounds.
struct LeastSquares {
  Eigen::VectorXd low, high;
  std::vector<bool> held;  ///< variables that stay where they start
  /// Residuals and their Jacobian at x; false where there are none.
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian)> evaluate;
  int n_residuals;
  int n_robust;  ///< the first so many residuals are subject to the loss
  Loss loss;
  double loss_scale;
  double enough = 0.0;           ///< ends where a step changes the cost by less
  std::function<bool()> stop{};  ///< asked after each step; true ends the descent where it is
};

struct Minimum {
  Eigen::VectorXd x;
  double cost;     ///< half the sum, with the loss
  bool converged;  ///< not by `stop`
  std::string message;
};

/// A local minimum from `start`, which lies between the bounds and has residuals. None where there are none at it.
[[nodiscard]] std::optional<Minimum> minimise(const LeastSquares& problem, const Eigen::VectorXd& start);

}  // namespace talus::fit
