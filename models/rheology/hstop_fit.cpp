#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <vector>

#include "rheology/checks.hpp"
#include "rheology/hstop.hpp"

namespace talus::rheology {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument("h_stop data: " + why); }

std::string rounded(double value) {
  std::ostringstream out;
  out << std::setprecision(4) << value;
  return out.str();
}

void check(std::span<const HstopPoint> points) {
  if (points.size() < 4)
    refuse(std::to_string(points.size()) + " points; expected at least 4, for three parameters and their errors");
  std::set<double> angles, thicknesses;
  for (const auto& [zeta, h] : points) {
    if (!(zeta > 0.0 && zeta < 0.5 * std::numbers::pi))
      refuse("zeta = " + checks::text(zeta) + " rad; expected angles above 0 and below pi/2");
    if (!(h > 0.0 && std::isfinite(h))) refuse("h_stop = " + checks::text(h) + " m; expected thicknesses above 0");
    angles.insert(zeta);
    thicknesses.insert(h);
  }
  if (angles.size() < 3)
    refuse("all points lie at " + std::to_string(angles.size()) + " angle(s); expected at least 3 different ones");
  if (thicknesses.size() < 3)
    refuse("there are only " + std::to_string(thicknesses.size()) +
           " different thicknesses; expected at least 3 different ones");
}

/// Residuals of (A2) in (mu_s, mu_d, log L).
class Residuals : public Eigen::DenseFunctor<double> {
 public:
  explicit Residuals(std::span<const HstopPoint> points)
      : DenseFunctor(3, static_cast<int>(points.size())), h_(points.size()), mu_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      h_[static_cast<Eigen::Index>(i)] = points[i].thickness;
      mu_[static_cast<Eigen::Index>(i)] = std::tan(points[i].zeta);
    }
  }

  int operator()(const Vector& x, Vector& residual) const {
    const auto s = shares(x[2]);
    residual = x[0] * (1.0 - s) + x[1] * s - mu_.array();
    return 0;
  }
  int df(const Vector& x, Matrix& jacobian) const {
    const auto s = shares(x[2]);
    jacobian.resize(h_.size(), 3);
    jacobian.col(0) = 1.0 - s;
    jacobian.col(1) = s;
    jacobian.col(2) = (x[1] - x[0]) * s * (1.0 - s);
    return 0;
  }

  /// The best of starts with log L across the measured thicknesses and beyond: given L, mu_s and mu_d are linear.
  [[nodiscard]] Vector start() const {
    const double low = std::log(1e-2 * h_.minCoeff()), high = std::log(1e2 * h_.maxCoeff());
    constexpr int n = 60;
    Vector best(3), residual;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= n; ++i) {
      Vector x(3);
      x[2] = low + (high - low) * i / n;
      Matrix shape(h_.size(), 2);
      shape.col(0) = 1.0 - shares(x[2]);
      shape.col(1) = shares(x[2]);
      x.head(2) = shape.colPivHouseholderQr().solve(mu_);
      (*this)(x, residual);
      if (residual.squaredNorm() < least) least = residual.squaredNorm(), best = x;
    }
    return best;
  }

 private:
  /// 1/(h/L + 1).
  [[nodiscard]] Eigen::ArrayXd shares(double log_length) const {
    return 1.0 / (h_.array() * std::exp(-log_length) + 1.0);
  }
  Vector h_, mu_;
};

/// Smallest ratio of singular values of the scaled Jacobian: below it three parameters hang on angles known to better
/// than a ten thousandth, whatever the scatter of a few points may pretend.
constexpr double least_ratio = 1e-4;

/// Inverse of J^T J with the columns of J first scaled to one; refuses where they cannot be told apart.
Matrix inverse_normal(const Matrix& jacobian) {
  const Vector size = jacobian.colwise().norm();
  if (!(size.minCoeff() > 0.0)) refuse("they do not depend on all of mu_s, mu_d and L");
  const Matrix scaled = jacobian * size.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Matrix> svd(scaled, Eigen::ComputeThinV);
  const auto& values = svd.singularValues();
  if (!(values[2] > least_ratio * values[0]))
    refuse("mu_s, mu_d and L cannot be told apart; expected thicknesses from well below to well above L");
  const Matrix inverse = svd.matrixV() * values.cwiseAbs2().cwiseInverse().asDiagonal() * svd.matrixV().transpose();
  return size.cwiseInverse().asDiagonal() * inverse * size.cwiseInverse().asDiagonal();
}

}  // namespace

HstopFit fit_hstop(std::span<const HstopPoint> points) {
  check(points);
  Residuals residuals(points);
  Vector x = residuals.start();
  Eigen::LevenbergMarquardt<Residuals> solver(residuals);
  solver.setXtol(1e-14);
  solver.setFtol(1e-14);
  solver.setMaxfev(1000);
  solver.minimize(x);
  if (!x.allFinite()) refuse("the fit diverged");
  if (!(x[1] > x[0])) refuse("thickness does not fall as the slope grows, which (A2) needs");
  if (!(x[0] > 0.0)) refuse("the best mu_s is " + rounded(x[0]) + "; expected a curve with mu_s above 0");

  Vector residual;
  Matrix jacobian;
  residuals(x, residual);
  residuals.df(x, jacobian);
  const auto freedom = static_cast<double>(points.size() - 3);
  const double variance = residual.squaredNorm() / freedom;
  const Matrix shape = inverse_normal(jacobian);
  HstopFit fit{hstop_curve(x[0], x[1], std::exp(x[2])), {}, {}, std::sqrt(variance)};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      fit.correlation[i][j] = i == j ? 1.0 : shape(i, j) / std::sqrt(shape(i, i) * shape(j, j));
    }
    fit.error[i] = std::sqrt(variance * shape(i, i)) * (i == 2 ? fit.curve.length : 1.0);
    const double value = i == 0 ? fit.curve.mu_s : i == 1 ? fit.curve.mu_d : fit.curve.length;
    static constexpr const char* names[] = {"mu_s", "mu_d", "L"};
    if (!(fit.error[i] <= value))
      refuse(std::string(names[i]) + " = " + rounded(value) + " is uncertain by " + rounded(fit.error[i]) +
             ", more than itself; expected more points, or thicknesses over a wider range");
  }
  return fit;
}

}  // namespace talus::rheology
