#include "ida/step_newton.hpp"

#include <ida/ida.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numeric>

namespace talus::ida {
namespace {

StepNewton& self_of(SUNNonlinearSolver handle) { return *static_cast<StepNewton*>(handle->content); }

}  // namespace

SUNNonlinearSolver StepNewton::make_handle(StepNewton& self, SUNContext context) {
  SUNNonlinearSolver handle = SUNNonlinSolNewEmpty(context);
  if (handle == nullptr) throw std::bad_alloc();
  handle->content = &self;
  auto& ops = *handle->ops;
  ops.gettype = [](SUNNonlinearSolver) { return SUNNONLINEARSOLVER_ROOTFIND; };
  ops.setsysfn = [](SUNNonlinearSolver h, SUNNonlinSolSysFn function) {
    self_of(h).system_function_ = function;
    return SUN_NLS_SUCCESS;
  };
  // The weighted norm and the convergence test are our own, and IDA has no linear solver to offer.
  ops.solve = [](SUNNonlinearSolver h, N_Vector, N_Vector correction, N_Vector weights, realtype tolerance, booleantype,
                 void* memory) {
    self_of(h).step_memory_ = memory;
    return self_of(h).solve_step(correction, weights, tolerance);
  };
  ops.getnumiters = [](SUNNonlinearSolver h, long* n) {
    *n = self_of(h).newton_.iterations();
    return SUN_NLS_SUCCESS;
  };
  ops.getcuriter = [](SUNNonlinearSolver h, int* n) {
    *n = self_of(h).newton_.iterations();
    return SUN_NLS_SUCCESS;
  };
  ops.getnumconvfails = [](SUNNonlinearSolver h, long* n) {
    *n = self_of(h).failures_;
    return SUN_NLS_SUCCESS;
  };
  return handle;
}

StepNewton::StepNewton(Equations& equations, const NewtonOptions& options, void* ida_memory, SUNContext context)
    : equations_(equations),
      newton_(options),
      ida_memory_(ida_memory),
      handle_(make_handle(*this, context)),
      x_(equations.size(), context),
      g_(equations.size(), context),
      y_(equations.size()),
      yp_(equations.size()),
      rounding_(equations.system().layout().fields.size(), 0.0) {
  const auto& layout = equations.system().layout();
  for (std::size_t i = 0; i < y_.size(); ++i)
    if (const double most = layout.fields[layout.field_of[i]].newton_bound; std::isfinite(most))
      bounded_.push_back({i, most});
}

StepNewton::~StepNewton() { SUNNonlinSolFreeEmpty(handle_); }

int StepNewton::solve_step(N_Vector correction, N_Vector weights, double tolerance) {
  weights_ = weights;
  N_Vector y = nullptr, yp = nullptr, residual = nullptr;
  void* user = nullptr;
  IDAGetNonlinearSystemData(ida_memory_, &t_, &predicted_y_, &predicted_yp_, &y, &yp, &residual, &c_j_, &user);
  const auto status = newton_.solve(*this, view(correction), tolerance);
  failures_ = status == DampedNewton::Status::converged ? 0 : 1;
  switch (status) {
    case DampedNewton::Status::converged: return SUN_NLS_SUCCESS;
    case DampedNewton::Status::diverged: return SUN_NLS_CONV_RECVR;
    case DampedNewton::Status::refused: return refused_by_residual;
    case DampedNewton::Status::broken: break;
  }
  return IDA_RES_FAIL;
}

Outcome StepNewton::residual(std::span<const double> x, std::span<double> g) {
  std::copy(x.begin(), x.end(), x_.span().begin());
  const int flag = system_function_(x_.handle(), g_.handle(), step_memory_);
  if (flag != 0) return flag > 0 ? Outcome::refused : Outcome::broken;
  std::copy(g_.span().begin(), g_.span().end(), g.begin());
  return Outcome::ok;
}

Outcome StepNewton::refresh(std::span<const double> x) {
  const auto y = view(predicted_y_), yp = view(predicted_yp_);
  for (std::size_t i = 0; i < x.size(); ++i) {
    y_[i] = y[i] + x[i];
    yp_[i] = yp[i] + c_j_ * x[i];
  }
  const auto outcome = equations_.refresh(t_, y_, yp_, c_j_);
  if (outcome == Outcome::ok) estimate_rounding();
  return outcome;
}

/// Rounding of row i: a few units in the last place of sum_j |J_ij y_j|.
void StepNewton::estimate_rounding() {
  constexpr double few_units = 1e-15;
  const auto& layout = equations_.system().layout();
  const auto& pattern = equations_.system().pattern();
  std::vector<double> row(y_.size(), 0.0);
  for (std::size_t j = 0; j < y_.size(); ++j)
    for (auto k = pattern.column_starts()[j]; k < pattern.column_starts()[j + 1]; ++k)
      row[pattern.rows()[k]] += few_units * std::abs(equations_.jacobian()[k] * y_[j]);
  rounding_.assign(layout.fields.size(), 0.0);
  for (std::size_t i = 0; i < row.size(); ++i) rounding_[layout.field_of[i]] += row[i] * row[i];
}

Outcome StepNewton::solve(std::span<double> b) {
  const auto outcome = equations_.solve(b);
  if (const double factor = scale(); factor != 1.0) {
    for (double& v : b) v *= factor;
  }
  return outcome;
}

double StepNewton::product(std::span<const double> a, std::span<const double> b) const {
  const auto w = view(weights_);
  // Eight sums side by side: one alone waits for each addition. Their order is fixed, so are the bits.
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> sums{};
  std::size_t i = 0;
  for (; i + lanes <= a.size(); i += lanes)
    for (std::size_t l = 0; l < lanes; ++l) sums[l] += (a[i + l] * w[i + l]) * (b[i + l] * w[i + l]);
  for (; i < a.size(); ++i) sums[0] += (a[i] * w[i]) * (b[i] * w[i]);
  return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(a.size());
}

double StepNewton::largest(std::span<const double> v) const {
  double most = 0.0;
  for (const auto& bounded : bounded_) most = std::max(most, std::abs(v[bounded.unknown]) / bounded.most);
  return most;
}

double StepNewton::share_left(std::span<const double> g, std::span<const double> g_start) const {
  const auto& layout = equations_.system().layout();
  std::vector<double> now(layout.fields.size(), 0.0), start(now);
  for (std::size_t i = 0; i < g.size(); ++i) {
    now[layout.field_of[i]] += g[i] * g[i];
    start[layout.field_of[i]] += g_start[i] * g_start[i];
  }
  double most = 0.0;
  for (std::size_t f = 0; f < now.size(); ++f)
    if (now[f] > rounding_[f]) most = std::max(most, now[f] / std::max(start[f], rounding_[f]));
  return std::sqrt(most);
}

double StepNewton::drift() const {
  if (equations_.c_j() == 0.0) return HUGE_VAL;
  return std::abs(c_j_ - equations_.c_j()) / (c_j_ + equations_.c_j());
}

}  // namespace talus::ida
