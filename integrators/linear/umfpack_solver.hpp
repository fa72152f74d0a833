#pragma once

#include "linear/checked_solver.hpp"

namespace talus::linear {

/// UMFPACK: multifrontal LU with dense blocks, for 2-D grids. Refinement is CheckedSolver's. Pivots are searched each
/// time.
///
/// Its strategy is set, not left to UMFPACK, which takes the symmetric one for any matrix of symmetric pattern: that
/// one orders with AMD and pivots on the diagonal, and is the better by far where the diagonal is good and useless on a
/// plain saddle point. `dissected` is that one with METIS' nested dissection: for large grids.
class UmfpackSolver final : public CheckedSolver {
 public:
  enum class Strategy { symmetric, dissected, unsymmetric };

  explicit UmfpackSolver(const SparsePattern& pattern, Strategy strategy = Strategy::unsymmetric);
  ~UmfpackSolver() override;
  [[nodiscard]] std::string describe() const override;
  [[nodiscard]] std::string chosen() const override { return name(strategy_); }
  static std::string name(Strategy s);

 protected:
  void factor_anew() override;
  void substitute(std::span<double> b) override;

 private:
  Strategy strategy_;
  std::vector<double> control_;
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

}  // namespace talus::linear
