#include "ida/step_newton.hpp"

#include <ida/ida.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "core/sums.hpp"

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
  ops.setsysfn = [](SUNNonlinearSolver, SUNNonlinSolSysFn) { return SUN_NLS_SUCCESS; };  // see residual()
  // The weighted norm and the convergence test are our own, and IDA has no linear solver to offer.
  ops.solve = [](SUNNonlinearSolver h, N_Vector, N_Vector correction, N_Vector weights, realtype tolerance, booleantype,
                 void*) { return self_of(h).solve_step(correction, weights, tolerance); };
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

/// The state that a correction x of the prediction means.
void StepNewton::apply(std::span<const double> x) {
  const double *y = view(predicted_y_).data(), *yp = view(predicted_yp_).data();
  core::in_halves(x.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      y_[i] = y[i] + x[i];
      yp_[i] = yp[i] + c_j_ * x[i];
    }
  });
}

/// IDA's own function would do the same, and keep copies that nobody reads.
Outcome StepNewton::residual(std::span<const double> x, std::span<double> g) {
  apply(x);
  return equations_.residual(t_, y_, yp_, g);
}

Outcome StepNewton::refresh(std::span<const double> x) {
  apply(x);
  const auto outcome = equations_.refresh(t_, y_, yp_, c_j_);
  if (outcome == Outcome::ok) estimate_rounding();
  return outcome;
}

/// Rounding of row i: a few units in the last place of sum_j |J_ij y_j|, no y_j counting as less than its absolute tolerance: in rows of
/// unknowns that are nothing, errors of substitution would pass for residuals.
void StepNewton::estimate_rounding() {
  constexpr double few_units = 1e-15;
  const auto& layout = equations_.system().layout();
  const auto& pattern = equations_.system().pattern();
  std::vector<double> row(y_.size(), 0.0);
  for (std::size_t j = 0; j < y_.size(); ++j) {
    const double size = std::max(std::abs(y_[j]), layout.fields[layout.field_of[j]].absolute_tolerance);
    for (auto k = pattern.column_starts()[j]; k < pattern.column_starts()[j + 1]; ++k)
      row[pattern.rows()[k]] += few_units * std::abs(equations_.jacobian()[k]) * size;
  }
  rounding_.assign(layout.fields.size(), 0.0);
  for (std::size_t i = 0; i < row.size(); ++i) rounding_[layout.field_of[i]] += row[i] * row[i];
}

Outcome StepNewton::solve(std::span<double> b) {
  const auto outcome = equations_.solve(b);
  if (const double factor = scale(); factor != 1.0)
    core::in_halves(b.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) b[i] *= factor;
    });
  return outcome;
}

double StepNewton::product(std::span<const double> a, std::span<const double> b) const {
  const double *x = a.data(), *y = b.data(), *weights = view(weights_).data();
  const double sum = core::sum_in_halves(a.size(), [=](auto read, std::size_t i) {
    const auto w = read(weights + i);
    return (read(x + i) * w) * (read(y + i) * w);
  });
  return sum / static_cast<double>(a.size());
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
