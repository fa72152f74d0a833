#pragma once

#include <Eigen/Core>
#include <vector>

namespace talus::fit {

/// What residuals with standard deviation one say of the variables near a minimum.
struct Identifiability {
  /// Variables as they enter: changes in units of `scale`.
  Eigen::VectorXd scale;
  Eigen::VectorXd
      singular_values;  ///< descending, one a free variable; 1/value is the standard deviation along its direction
  Eigen::MatrixXd directions;  ///< columns: changes of all variables in units of `scale`; zero for those held
  int rank;                    ///< directions seen: singular value above 1e-7 of the largest, and above the noise
  Eigen::MatrixXd covariance;  ///< in the variables' own units, over the directions seen
  double blur;                 ///< share of a gradient that may point along directions unseen: they are known so well

  /// Whether what changes by `gradient` (per unit of each variable) is fixed by the residuals: it does not change along
  /// any direction unseen.
  [[nodiscard]] bool sees(const Eigen::VectorXd& gradient) const;
  /// Its standard deviation. Precondition: sees(gradient).
  [[nodiscard]] double error(const Eigen::VectorXd& gradient) const;
};

/// Variables that are `held`, as those at a bound, count as known. `noise`: of singular values, where derivatives are
/// differences of runs; a direction below three times it is not seen.
[[nodiscard]] Identifiability identifiability(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& scale,
                                              const std::vector<bool>& held, double noise = 0.0);

}  // namespace talus::fit
