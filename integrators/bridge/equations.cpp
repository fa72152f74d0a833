#include "bridge/equations.hpp"

#include <cmath>
#include <ctime>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/errors.hpp"
#include "core/sums.hpp"

namespace talus::bridge {
namespace {

/// Adds the CPU time of its life to a counter.
class Timer {
 public:
  explicit Timer(double& seconds) : seconds_(seconds), begin_(std::clock()) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() { seconds_ += static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

 private:
  double& seconds_;
  std::clock_t begin_;
};

}  // namespace

Equations::Equations(const core::DaeSystem& system, const linear::Settings& settings, core::Statistics& statistics)
    : system_(system),
      statistics_(statistics),
      settings_(settings),
      solver_(linear::make_solver(system.pattern(), settings)),
      values_(system.pattern().n_nonzeros()) {
  for (const auto& field : system.layout().fields) {
    if (!(field.absolute_tolerance > 0.0)) {
      throw std::invalid_argument("field " + field.name + " needs a positive absolute tolerance");
    }
  }
}

Outcome Equations::residual(double t, std::span<const double> y, std::span<const double> yp,
                            std::span<double> r) noexcept {
  const Timer timer(statistics_.seconds_residual);
  ++statistics_.residuals;
  try {
    try {
      system_.residual(t, y, yp, r);
    } catch (const core::InadmissibleState& state) { return refuse(t, state.what()); }
    if (core::all_finite(r)) return Outcome::ok;
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (!std::isfinite(r[i])) {
        return refuse(t, "the residual is not finite in the row of " + system_.describe(static_cast<core::Index>(i)));
      }
    }
    return Outcome::ok;
  } catch (...) {
    broken_ = std::current_exception();
    return Outcome::broken;
  }
}

Outcome Equations::refresh(double t, std::span<const double> y, std::span<const double> yp, double c_j) noexcept {
  c_j_ = 0.0;
  try {
    try {
      {
        const Timer timer(statistics_.seconds_jacobian);
        ++statistics_.jacobians;
        system_.jacobian(t, y, yp, c_j, values_);
      }
      const Timer timer(statistics_.seconds_factor);
      ++statistics_.factorisations;
      solver_->factor(values_);
    } catch (const core::InadmissibleState& state) {
      return refuse(t, state.what());
    } catch (const linear::SingularMatrix& matrix) { return refuse(t, in_words(matrix)); }
    c_j_ = c_j;
    factors_t_ = t;
    return Outcome::ok;
  } catch (...) {
    broken_ = std::current_exception();
    return Outcome::broken;
  }
}

Outcome Equations::solve(std::span<double> b) noexcept {
  const Timer timer(statistics_.seconds_solve);
  ++statistics_.solves;
  try {
    try {
      solver_->solve(b);
    } catch (const linear::SingularMatrix& matrix) { return refuse(factors_t_, in_words(matrix)); }
    return Outcome::ok;
  } catch (...) {
    broken_ = std::current_exception();
    return Outcome::broken;
  }
}

void Equations::renew_solver(const std::string& chosen) {
  settings_.chosen = chosen;
  solver_ = linear::make_solver(system_.pattern(), settings_);
  forget_factors();
}

void Equations::rethrow() {
  if (broken_) std::rethrow_exception(std::exchange(broken_, nullptr));
}

std::string Equations::in_words(const linear::SingularMatrix& matrix) const {
  std::string why = std::string("Jacobian: ") + matrix.what();
  if (matrix.place() >= 0) why += ", at " + system_.describe(matrix.place());
  return why;
}

Outcome Equations::refuse(double t, const std::string& why) {
  ++statistics_.inadmissible_states;
  std::ostringstream message;
  message.precision(12);
  message << why << " (at t = " << t << " s)";
  refusal_ = message.str();
  return Outcome::refused;
}

}  // namespace talus::bridge
