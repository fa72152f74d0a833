#pragma once

#include <string>

#include "linear/direct_solver.hpp"

namespace talus::linear {

/// Takes, on the first matrix, the solver with the least predicted time of a factorisation among those whose test solve
/// passes.
///
/// The prediction is counted operations over the typical speed of each library's kernels, not a stopwatch: the same
/// matrix gives the same choice, hence the same rounding, in every run.
class AutomaticSolver final : public DirectSolver {
 public:
  AutomaticSolver(const SparsePattern& pattern, Settings settings);

  void factor(std::span<const double> values) override;
  void solve(std::span<double> b) override { chosen_->solve(b); }
  [[nodiscard]] const Statistics& statistics() const override;
  [[nodiscard]] std::string chosen() const override { return chosen_ ? chosen_->chosen() : ""; }
  [[nodiscard]] std::string describe() const override;

 private:
  void choose(std::span<const double> values);

  const SparsePattern& pattern_;
  Settings settings_;
  std::unique_ptr<DirectSolver> chosen_;
  std::string trials_;
};

}  // namespace talus::linear
