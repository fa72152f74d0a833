#pragma once

#include <memory>
#include <string>
#include <vector>

#include "linear/checked_solver.hpp"

namespace talus::linear {

/// KLU: left-looking sparse LU without dense blocks, best for thin grids and up to about 10^4 unknowns.
///
/// The first matrix decides the ordering: COLAMD, COLAMD in block triangular form where that breaks the matrix up, AMD,
/// or a given one; the fewest operations win among those whose test solve passes. A candidate that outgrows the best
/// factors so far is stopped (AMD on a saddle point may need a hundred times the time of COLAMD). Later matrices reuse
/// the pivots while the residual allows.
class KluSolver final : public CheckedSolver {
 public:
  struct Settings {
    double pivot_tolerance = 0.1;  ///< take a diagonal pivot of this size relative to the largest entry of its column
    std::vector<Index> ordering = {};  ///< optional: unknown number k of the elimination, shape n
    Index max_fill = 0;     ///< give up (SingularMatrix) above this many entries of L + U on the first matrix; 0: none
    std::string only = {};  ///< the ordering to take, as chosen() names it; "": try all
  };

  explicit KluSolver(const SparsePattern& pattern) : KluSolver(pattern, Settings{}) {}
  KluSolver(const SparsePattern& pattern, Settings settings);
  ~KluSolver() override;
  [[nodiscard]] std::string describe() const override;
  [[nodiscard]] std::string chosen() const override;
  static constexpr const char* library = "KLU";  ///< followed by " " and the ordering in chosen()

 protected:
  void factor_anew() override;
  bool refactor() override;
  void substitute(std::span<double> b) override;

 private:
  struct Factors;
  std::unique_ptr<Factors> attempt(const std::string& name, Index max_fill);
  void choose();

  Settings settings_;
  std::vector<Index> starts_, rows_;  // KLU wants them mutable
  std::unique_ptr<Factors> factors_;
  std::string trials_;
};

}  // namespace talus::linear
