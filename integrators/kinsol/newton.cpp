#include "kinsol/newton.hpp"

#include <kinsol/kinsol.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <utility>

namespace talus::kinsol {
namespace {

using bridge::Outcome;
using bridge::view;

/// For calls that fail only by a mistake of ours.
void must(int flag, const char* call) {
  if (flag != KIN_SUCCESS) throw std::runtime_error(std::string(call) + " failed with flag " + std::to_string(flag));
}

/// KINSOL 6.4.1 does not know the names of all its flags.
std::string flag_name(int flag) {
  if (flag == KIN_REPTD_SYSFUNC_ERR) return "KIN_REPTD_SYSFUNC_ERR";
  if (flag == KIN_FIRST_SYSFUNC_ERR) return "KIN_FIRST_SYSFUNC_ERR";
  char* name = KINGetReturnFlagName(flag);
  std::string copy(name);
  std::free(name);
  return copy;
}

}  // namespace

Newton::Memory::Memory() {
  if (SUNContext_Create(nullptr, &context) != 0) throw std::bad_alloc();
  kinsol = KINCreate(context);
  if (kinsol == nullptr) throw std::bad_alloc();
}

Newton::Memory::~Memory() {
  KINFree(&kinsol);
  SUNContext_Free(&context);
}

Newton::Newton(bridge::Equations& equations, const Options& options, core::Statistics& statistics)
    : equations_(equations),
      options_(options),
      statistics_(statistics),
      linear_(equations, memory_.context),
      y_(equations.size(), memory_.context),
      unknown_scale_(equations.size(), memory_.context),
      row_scale_(equations.size(), memory_.context),
      rate_(equations.size()),
      r_(equations.size()) {
  const auto& layout = equations.system().layout();
  for (core::Index i = 0; i < layout.size(); ++i) {
    unknown_scale_.span()[i] = options.rtol / layout.field(i).absolute_tolerance;
  }
  void* kinsol = memory_.kinsol;
  must(KINSetErrHandlerFn(
           kinsol,
           [](int, const char*, const char*, char* message, void* self) {
             static_cast<Newton*>(self)->message_ = message;
           },
           this),
       "KINSetErrHandlerFn");
  must(KINInit(
           kinsol,
           [](N_Vector y, N_Vector r, void* self) {
             return bridge::flag(static_cast<Newton*>(self)->residual(view(y), view(r)));
           },
           y_.handle()),
       "KINInit");
  must(KINSetUserData(kinsol, this), "KINSetUserData");
  must(KINSetLinearSolver(kinsol, linear_.solver(), linear_.matrix()), "KINSetLinearSolver");
  must(KINSetJacFn(kinsol, [](N_Vector y, N_Vector, SUNMatrix, void* self, N_Vector,
                              N_Vector) { return bridge::flag(static_cast<Newton*>(self)->refresh(view(y))); }),
       "KINSetJacFn");
  must(KINSetMaxSetupCalls(kinsol, 1), "KINSetMaxSetupCalls");
  // Steps are as long as the line search wants them: at rest, where KINSOL takes its limit from, nothing is known.
  must(KINSetMaxNewtonStep(kinsol, DBL_MAX), "KINSetMaxNewtonStep");
  must(KINSetMaxBetaFails(kinsol, 1000000), "KINSetMaxBetaFails");
}

Newton::~Newton() = default;

bool Newton::solve(const Target& target, std::span<double> y, int max_iterations) {
  target_ = target;
  iterations_ = 0;
  factored_ = false;
  std::copy(y.begin(), y.end(), y_.span().begin());
  bool found = false, searching = true;
  for (double kinsol_tolerance = options_.tolerance * options_.rtol; searching;) {
    if (!prepare()) break;
    must(KINSetFuncNormTol(memory_.kinsol, kinsol_tolerance), "KINSetFuncNormTol");
    must(KINSetScaledStepTol(memory_.kinsol, kinsol_tolerance), "KINSetScaledStepTol");
    must(KINSetNumMaxIters(memory_.kinsol, std::max(1, max_iterations - iterations_)), "KINSetNumMaxIters");
    message_.clear();
    const int flag = KINSol(memory_.kinsol, y_.handle(), KIN_LINESEARCH, unknown_scale_.handle(), row_scale_.handle());
    factored_ = false;
    equations_.rethrow();
    long n = 0;
    KINGetNumNonlinSolvIters(memory_.kinsol, &n);
    iterations_ += static_cast<int>(n);
    why_ = flag_name(flag) + (message_.empty() ? "" : ": " + message_);
    const bool stopped = flag >= 0 || flag == KIN_LINESEARCH_NONCONV;
    found = stopped && correct();
    searching = flag >= 0 && !found && iterations_ < max_iterations;
    kinsol_tolerance = std::max(0.01 * kinsol_tolerance, DBL_MIN);  // 0 would mean KINSOL's default
  }
  statistics_.newton_iterations += iterations_;
  if (!found) ++statistics_.newton_failures;
  std::copy(y_.span().begin(), y_.span().end(), y.begin());
  return found;
}

/// Jacobian and row scales at y_; KINSOL then finds its first factors made.
bool Newton::prepare() {
  const auto outcome = refresh(y_.span());
  equations_.rethrow();
  if (outcome != Outcome::ok) {
    why_ = "no usable Jacobian at the first iterate";
    return false;
  }
  scale_rows(y_.span());
  factored_ = true;
  return true;
}

/// With the last factors, those of the last iterate but one: makes Newton's correction if it is small and does what it
/// promises, and says so. Where the Jacobian is stiff at rest and soft in motion, a small correction alone means nothing.
bool Newton::correct() {
  const auto y = y_.span();
  auto ok = residual(y, r_) == Outcome::ok;
  const double before = ok ? scaled_size(r_) : 0.0;
  ok = ok && equations_.solve(r_) == Outcome::ok;
  equations_.rethrow();
  if (!ok) return false;
  const auto& layout = equations_.system().layout();
  for (std::size_t i = 0; i < r_.size(); ++i) {
    const double weight = options_.rtol * std::abs(y[i]) + layout.field(static_cast<core::Index>(i)).absolute_tolerance;
    if (!(std::abs(r_[i]) <= options_.tolerance * weight)) return false;
  }
  std::vector<double> corrected(y.begin(), y.end());
  for (std::size_t i = 0; i < r_.size(); ++i) corrected[i] -= r_[i];
  ok = residual(corrected, r_) == Outcome::ok;
  equations_.rethrow();
  if (!ok || !(scaled_size(r_) <= kept_promise * before || is_rounding(corrected, r_))) return false;
  std::copy(corrected.begin(), corrected.end(), y.begin());
  return true;
}

double Newton::scaled_size(std::span<const double> r) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < r.size(); ++i) largest = std::max(largest, std::abs(r[i]) * row_scale_.span()[i]);
  return largest;
}

/// Whether each row of r is of the size of rounding in its terms at y, sum_j |J_ij y_j|.
bool Newton::is_rounding(std::span<const double> y, std::span<const double> r) const {
  std::vector<double> terms(r.size(), 0.0);
  const auto& pattern = equations_.system().pattern();
  const auto starts = pattern.column_starts();
  const auto rows = pattern.rows();
  const auto values = equations_.jacobian();
  for (core::Index j = 0; j < pattern.n(); ++j) {
    for (core::Index k = starts[j]; k < starts[j + 1]; ++k) terms[rows[k]] += std::abs(values[k] * y[j]);
  }
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (std::abs(r[i]) > 1e3 * DBL_EPSILON * terms[i]) return false;
  }
  return true;
}

bridge::Outcome Newton::residual(std::span<const double> y, std::span<double> r) {
  return equations_.residual(target_.t, y, rate(y), r);
}

bridge::Outcome Newton::refresh(std::span<const double> y) {
  if (std::exchange(factored_, false)) return Outcome::ok;
  return equations_.refresh(target_.t, y, rate(y), target_.c_j);
}

std::span<const double> Newton::rate(std::span<const double> y) {
  const auto& layout = equations_.system().layout();
  for (std::size_t i = 0; i < rate_.size(); ++i) {
    const bool moves = target_.c_j > 0.0 && layout.field(static_cast<core::Index>(i)).kind == core::Kind::differential;
    rate_[i] = moves ? target_.c_j * (y[i] - target_.from[i]) : 0.0;
  }
  return rate_;
}

void Newton::scale_rows(std::span<const double> y) {
  const auto& layout = equations_.system().layout();
  const auto& pattern = equations_.system().pattern();
  const auto starts = pattern.column_starts();
  const auto rows = pattern.rows();
  const auto values = equations_.jacobian();
  const auto scale = row_scale_.span();
  std::fill(scale.begin(), scale.end(), 0.0);
  for (core::Index j = 0; j < pattern.n(); ++j) {
    const double size = std::abs(y[j]) + 1.0 / unknown_scale_.span()[j];
    for (core::Index k = starts[j]; k < starts[j + 1]; ++k) scale[rows[k]] += std::abs(values[k]) * size;
  }
  if (target_.c_j > 0.0) {
    std::vector<double> largest(layout.fields.size(), 0.0);
    for (std::size_t i = 0; i < scale.size(); ++i) {
      auto& of_field = largest[layout.field_of[i]];
      of_field = std::max(of_field, scale[i]);
    }
    for (std::size_t i = 0; i < scale.size(); ++i) scale[i] = largest[layout.field_of[i]];
  }
  for (double& s : scale) s = s > 0.0 ? 1.0 / s : 1.0;
}

std::vector<double> Newton::scaled_residual(const Target& target, std::span<const double> y) {
  target_ = target;
  factored_ = false;
  std::vector<double> r(y.size(), 0.0);
  if (residual(y, r) == Outcome::broken || refresh(y) == Outcome::broken) equations_.rethrow();
  scale_rows(y);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] *= row_scale_.span()[i];
  return r;
}

double Newton::relative_change(std::span<const double> a, std::span<const double> b) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(b[i] - a[i]) / (std::abs(b[i]) + 1.0 / unknown_scale_.span()[i]));
  }
  return largest;
}

}  // namespace talus::kinsol
