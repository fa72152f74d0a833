#pragma once

#include <sundials/sundials_nonlinearsolver.h>

#include <vector>

#include "bridge/vectors.hpp"
#include "ida/damped_newton.hpp"

namespace talus::ida {

using bridge::Equations;
using bridge::Vector;
using bridge::view;

/// DampedNewton as the SUNNonlinearSolver of IDA's steps. It owns the way to the Jacobian and its factors (through
/// Equations), so IDA gets no linear solver and decides nothing about either.
class StepNewton final : private NewtonProblem {
 public:
  /// `ida_memory` is IDA's, `equations` must outlive this.
  StepNewton(Equations& equations, const NewtonOptions& options, void* ida_memory, SUNContext context);
  StepNewton(const StepNewton&) = delete;
  StepNewton& operator=(const StepNewton&) = delete;
  ~StepNewton() override;

  [[nodiscard]] SUNNonlinearSolver handle() const { return handle_; }
  [[nodiscard]] const DampedNewton& newton() const { return newton_; }
  void forget() { newton_.forget(); }

 private:
  static constexpr int refused_by_residual = 1;  ///< IDA's private flag for a residual that asks for a smaller step

  Outcome residual(std::span<const double> x, std::span<double> g) override;
  Outcome refresh(std::span<const double> x) override;
  Outcome solve(std::span<double> b) override;
  /// For factors of another c_j: it balances the errors of slow and of stiff components.
  [[nodiscard]] double scale() const override { return 2.0 / (1.0 + c_j_ / equations_.c_j()); }
  [[nodiscard]] double product(std::span<const double> a, std::span<const double> b) const override;
  [[nodiscard]] double largest(std::span<const double> v) const override;
  [[nodiscard]] double drift() const override;
  /// Groups are the fields.
  [[nodiscard]] double share_left(std::span<const double> g, std::span<const double> g_start) const override;

  void apply(std::span<const double> x);
  void estimate_rounding();
  int solve_step(N_Vector correction, N_Vector weights, double tolerance);
  static SUNNonlinearSolver make_handle(StepNewton& self, SUNContext context);

  Equations& equations_;
  DampedNewton newton_;
  void* ida_memory_;
  SUNNonlinearSolver handle_;
  N_Vector weights_ = nullptr;
  double t_ = 0.0, c_j_ = 0.0;
  N_Vector predicted_y_ = nullptr, predicted_yp_ = nullptr;
  std::vector<double> y_, yp_;
  std::vector<double> rounding_;  // squares of residuals that are rounding, summed over each field's rows
  struct Bounded {
    std::size_t unknown;
    double most;
  };
  std::vector<Bounded> bounded_;  // unknowns whose field has a newton_bound
  long failures_ = 0;
};

}  // namespace talus::ida
