#pragma once

#include <sundials/sundials_context.h>

#include <span>
#include <string>
#include <vector>

#include "bridge/equations.hpp"
#include "bridge/linear_shell.hpp"
#include "bridge/vectors.hpp"
#include "kinsol/options.hpp"

namespace talus::kinsol {

/// F(t, y, y') = 0 with y' = c_j (y - from) for differential unknowns and 0 for algebraic ones: an implicit Euler step of
/// size 1/c_j, or, with c_j = 0, the steady state.
struct Target {
  double t;                           ///< [s]
  double c_j = 0.0;                   ///< [1/s]
  std::span<const double> from = {};  ///< shape n; not read where c_j = 0
};

/// Newton's method with the exact Jacobian of each iterate, and with the line search of KINSOL.
///
/// Scales: an unknown counts relative to |y_i| + atol_i/rtol; a row of F relative to what its Jacobian at the first iterate
/// makes of unknowns of that size, sum_j |J_ij| (|y_j| + atol_j/rtol), or, in a step of the continuation, the largest such
/// sum of its field. The line search reduces the Euclidean norm of F so scaled. What is accepted is a small correction,
/// not a small F: see `solve`.
class Newton {
 public:
  /// All must outlive this.
  Newton(bridge::Equations& equations, const Options& options, core::Statistics& statistics);
  Newton(const Newton&) = delete;
  Newton& operator=(const Newton&) = delete;
  ~Newton();

  /// Improves y (shape n) until Newton's correction is below the tolerance in each weight and reduces F as it should; it
  /// is made. False where it cannot:
  /// y is then the last iterate, and why() says what KINSOL said. Throws what the system throws.
  bool solve(const Target& target, std::span<double> y, int max_iterations);
  /// Of the last solve().
  [[nodiscard]] int iterations() const { return iterations_; }
  /// Of the last solve() that failed, for example "KIN_MAXITER_REACHED: ...".
  [[nodiscard]] const std::string& why() const { return why_; }
  /// F at y, relative to the scales of its rows, shape n; zeros where F cannot be evaluated.
  [[nodiscard]] std::vector<double> scaled_residual(const Target& target, std::span<const double> y);
  /// The largest change from a to b, each relative to |b_i| + atol_i/rtol.
  [[nodiscard]] double relative_change(std::span<const double> a, std::span<const double> b) const;

 private:
  /// What the last correction may leave of F, as a share; nothing but rounding where F is that small.
  static constexpr double kept_promise = 0.1;

  bool prepare();
  bool correct();
  [[nodiscard]] double scaled_size(std::span<const double> r) const;
  [[nodiscard]] bool is_rounding(std::span<const double> y, std::span<const double> r) const;
  bridge::Outcome residual(std::span<const double> y, std::span<double> r);
  bridge::Outcome refresh(std::span<const double> y);
  std::span<const double> rate(std::span<const double> y);
  void scale_rows(std::span<const double> y);

  /// A SUNContext and KINSOL's memory, released in the right order.
  struct Memory {
    SUNContext context = nullptr;
    void* kinsol = nullptr;
    Memory();
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    ~Memory();
  };

  bridge::Equations& equations_;
  const Options& options_;
  core::Statistics& statistics_;
  Memory memory_;
  bridge::LinearShell linear_;
  bridge::Vector y_, unknown_scale_, row_scale_;  // the scales as KINSOL takes them, inverse
  Target target_{};
  std::vector<double> rate_, r_;
  bool factored_ = false;  // the factors at hand are those of y_
  int iterations_ = 0;
  std::string message_, why_;
};

}  // namespace talus::kinsol
