#pragma once

#include <exception>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/dae_system.hpp"
#include "core/statistics.hpp"
#include "linear/direct_solver.hpp"

namespace talus::bridge {

/// `refused`: not here, try a smaller step. `broken`: an exception that must end the integration.
enum class Outcome { ok, refused, broken };

/// What SUNDIALS wants of a callback: positive asks for a smaller step, negative ends the integration.
constexpr int flag(Outcome outcome) { return outcome == Outcome::ok ? 0 : (outcome == Outcome::refused ? 1 : -1); }

/// A DaeSystem behind a border that no exception crosses: evaluates, checks that everything is finite, factors, counts
/// and times.
class Equations {
 public:
  /// All must outlive this. Throws std::invalid_argument where a field has no positive absolute tolerance, and what
  /// linear::make_solver throws.
  Equations(const core::DaeSystem& system, const linear::Settings& settings, core::Statistics& statistics);

  /// r = F(t, y, y').
  Outcome residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) noexcept;
  /// Factors dF/dy + c_j dF/dy'.
  Outcome refresh(double t, std::span<const double> y, std::span<const double> yp, double c_j) noexcept;
  /// b <- J^-1 b with the factors at hand; `refused` where they turn out to be singular.
  Outcome solve(std::span<double> b) noexcept;

  /// c_j of the factors at hand; 0 where there are none.
  [[nodiscard]] double c_j() const { return c_j_; }
  void forget_factors() { c_j_ = 0.0; }
  /// A new linear solver: of all matrices before, it knows only what their trials came to, `chosen` (see
  /// linear::Settings). From here on the same states give the same bits, whatever came before.
  void renew_solver(const std::string& chosen);
  /// Why the last refusal was made, with its time; empty if there was none.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  void forget_refusal() { refusal_.clear(); }
  /// Throws the exception behind the last `broken`, if any.
  void rethrow();

  [[nodiscard]] const core::DaeSystem& system() const { return system_; }
  /// Of the last refresh(), in the order of the system's pattern.
  [[nodiscard]] std::span<const double> jacobian() const { return values_; }
  [[nodiscard]] core::Index size() const { return system_.layout().size(); }
  [[nodiscard]] const linear::DirectSolver& solver() const { return *solver_; }

 private:
  [[nodiscard]] std::string in_words(const linear::SingularMatrix& matrix) const;
  Outcome refuse(double t, const std::string& why);

  const core::DaeSystem& system_;
  core::Statistics& statistics_;
  linear::Settings settings_;
  std::unique_ptr<linear::DirectSolver> solver_;
  std::vector<double> values_;
  double c_j_ = 0.0;
  double factors_t_ = 0.0;  // [s] of the last factors
  std::string refusal_;
  std::exception_ptr broken_;
};

}  // namespace talus::bridge
