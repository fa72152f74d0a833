#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/evaluation.hpp"

namespace talus::fit {

/// The minimum of a model's sum of squares near `start`, with `held` variables staying there, and the condition of
/// well-posedness kept where it is asked for. None where some flow has no steady state at `start`.
struct LocalMinimum {
  Eigen::VectorXd x;
  double cost;  ///< half the sum of squares, with the loss; without what kept the condition
  bool converged;
  bool well_posed;  ///< the condition asked for holds
};
[[nodiscard]] std::optional<LocalMinimum> descend(const Model& model, const Eigen::VectorXd& start,
                                                  const std::vector<bool>& held);

/// Starting points with a steady state at every flow measured.
struct Starts {
  std::vector<Eigen::VectorXd> points;
  int infeasible = 0;
  std::string reason;  ///< of the first one without
};
/// The variables' own start, and draws between their bounds, always the same ones.
[[nodiscard]] Starts starting_points(const Model& model);

}  // namespace talus::fit
