#pragma once

#include "linear/checked_solver.hpp"

namespace talus::linear {

/// UMFPACK: multifrontal LU with dense blocks, for 2-D grids beyond about 10^4 unknowns. Its unsymmetric strategy is forced: the
/// automatic choice takes the symmetric one for a saddle point. Refinement is CheckedSolver's. Pivots are searched each time.
class UmfpackSolver final : public CheckedSolver {
 public:
  explicit UmfpackSolver(const SparsePattern& pattern);
  ~UmfpackSolver() override;
  [[nodiscard]] std::string describe() const override;

 protected:
  void factor_anew() override;
  void substitute(std::span<double> b) override;

 private:
  std::vector<double> control_;
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

}  // namespace talus::linear
