#include "fit/minimise.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace talus::fit {

namespace {

/// All residuals at the last point asked for: Ceres asks for them one by one.
class Cache {
 public:
  explicit Cache(const LeastSquares& problem) : problem_(problem), range_(problem.high - problem.low) {}

  [[nodiscard]] Eigen::VectorXd x(const double* t) const {
    return problem_.low + Eigen::Map<const Eigen::VectorXd>(t, range_.size()).cwiseProduct(range_);
  }
  /// Fractions of the way between the bounds, t, are Ceres' variables.
  bool bring(const double* t) {
    const Eigen::VectorXd asked = Eigen::Map<const Eigen::VectorXd>(t, range_.size());
    if (t_.size() == asked.size() && t_ == asked) return ok_;
    t_ = asked;
    ok_ = problem_.evaluate(x(t), residuals_, jacobian_) && residuals_.allFinite() && jacobian_.allFinite();
    if (ok_) jacobian_ = (jacobian_ * range_.asDiagonal()).eval();
    return ok_;
  }
  [[nodiscard]] double residual(int row) const { return residuals_[row]; }
  [[nodiscard]] auto derivatives(int row) const { return jacobian_.row(row); }

 private:
  const LeastSquares& problem_;
  Eigen::VectorXd range_, t_, residuals_;
  Eigen::MatrixXd jacobian_;
  bool ok_ = false;
};

class OneResidual : public ceres::CostFunction {
 public:
  OneResidual(Cache& cache, int row, int n_variables) : cache_(cache), row_(row) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(n_variables);
  }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    if (!cache_.bring(parameters[0])) return false;
    residuals[0] = cache_.residual(row_);
    if (jacobians != nullptr && jacobians[0] != nullptr)
      Eigen::Map<Eigen::RowVectorXd>(jacobians[0], parameter_block_sizes()[0]) = cache_.derivatives(row_);
    return true;
  }

 private:
  Cache& cache_;
  int row_;
};

/// Ends a descent whose steps have become too small to be worth their price, or that is told to stop.
class Patience : public ceres::IterationCallback {
 public:
  explicit Patience(const LeastSquares& problem) : problem_(problem) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    stopped_ = problem_.stop && problem_.stop();
    const bool small = step.iteration > 0 && std::abs(step.cost_change) < problem_.enough;
    return stopped_ || small ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  const LeastSquares& problem_;
  bool stopped_ = false;
};

ceres::LossFunction* loss_of(const LeastSquares& problem, int row) {
  if (row >= problem.n_robust) return nullptr;
  switch (problem.loss) {
    case Loss::huber: return new ceres::HuberLoss(problem.loss_scale);
    case Loss::cauchy: return new ceres::CauchyLoss(problem.loss_scale);
    default: return nullptr;
  }
}

}  // namespace

std::optional<Minimum> minimise(const LeastSquares& problem, const Eigen::VectorXd& start) {
  const int n = static_cast<int>(start.size());
  const Eigen::VectorXd range = problem.high - problem.low;
  Eigen::VectorXd t = (start - problem.low).cwiseQuotient(range).cwiseMax(0.0).cwiseMin(1.0);
  Cache cache(problem);
  if (!cache.bring(t.data())) return std::nullopt;
  std::vector<int> held;
  for (int i = 0; i < n; ++i)
    if (problem.held[static_cast<std::size_t>(i)]) held.push_back(i);
  ceres::Problem sum;
  for (int row = 0; row < problem.n_residuals; ++row)
    sum.AddResidualBlock(new OneResidual(cache, row, n), loss_of(problem, row), t.data());
  for (int i = 0; i < n; ++i) {
    sum.SetParameterLowerBound(t.data(), i, 0.0);
    sum.SetParameterUpperBound(t.data(), i, 1.0);
  }
  if (static_cast<int>(held.size()) == n) sum.SetParameterBlockConstant(t.data());
  else if (!held.empty()) sum.SetManifold(t.data(), new ceres::SubsetManifold(n, held));

  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-12;
  options.parameter_tolerance = 1e-10;
  options.gradient_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  Patience patience(problem);
  options.callbacks.push_back(&patience);
  if (problem.enough > 0.0) {  // evaluations are dear, and rough
    options.max_num_line_search_step_size_iterations = 0;
    options.initial_trust_region_radius = 10.0;  // steps a tenth short, and half as long at once where one fails
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options, &sum, &summary);
  const bool ended = summary.termination_type == ceres::CONVERGENCE || summary.termination_type == ceres::USER_SUCCESS;
  return Minimum{cache.x(t.data()), summary.final_cost, ended && !patience.stopped(), summary.message};
}

}  // namespace talus::fit
