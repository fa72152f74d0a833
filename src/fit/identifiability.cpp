#include "fit/identifiability.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace talus::fit {

namespace {
/// Derivatives are good to 1e-10; what the data do not contain at all is left with that.
constexpr double least_ratio = 1e-7;
/// Blur of directions by round-off, and by differences.
constexpr double round_off = 1e-5, differences = 0.05;
}  // namespace

Identifiability identifiability(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& scale,
                                const std::vector<bool>& held, double noise) {
  const Eigen::Index n = jacobian.cols();
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < n; ++i)
    if (!held[static_cast<std::size_t>(i)]) free.push_back(i);
  const auto n_free = static_cast<Eigen::Index>(free.size());
  // Rows of zeros make the thin decomposition complete where there are fewer data than variables.
  Eigen::MatrixXd scaled = Eigen::MatrixXd::Zero(std::max(jacobian.rows(), n_free), n_free);
  for (Eigen::Index k = 0; k < n_free; ++k)
    scaled.col(k).head(jacobian.rows()) =
        jacobian.col(free[static_cast<std::size_t>(k)]) * scale[free[static_cast<std::size_t>(k)]];
  Identifiability out{scale,
                      {},
                      Eigen::MatrixXd::Zero(n, n_free),
                      0,
                      Eigen::MatrixXd::Zero(n, n),
                      noise > 0.0 ? differences : round_off};
  if (n_free == 0) return out;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  out.singular_values = svd.singularValues();
  for (Eigen::Index k = 0; k < n_free; ++k)
    out.directions.row(free[static_cast<std::size_t>(k)]) = svd.matrixV().row(k);
  const double least = std::max(least_ratio * out.singular_values[0], 3.0 * noise);
  while (out.rank < n_free && out.singular_values[out.rank] > least) ++out.rank;
  for (int k = 0; k < out.rank; ++k) {
    const Eigen::VectorXd step = scale.cwiseProduct(out.directions.col(k)) / out.singular_values[k];
    out.covariance += step * step.transpose();
  }
  return out;
}

bool Identifiability::sees(const Eigen::VectorXd& gradient) const {
  const Eigen::VectorXd along = directions.transpose() * scale.cwiseProduct(gradient);
  return along.tail(along.size() - rank).norm() <= blur * along.norm();
}

double Identifiability::error(const Eigen::VectorXd& gradient) const {
  return std::sqrt(gradient.dot(covariance * gradient));
}

}  // namespace talus::fit
