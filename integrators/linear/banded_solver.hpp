#pragma once

#include "linear/checked_solver.hpp"

namespace talus::linear {

/// LAPACK's band LU (dgbtrf, dense blocks, partial pivoting within the band) of the reordered, row-scaled matrix: best
/// where the unknowns can be numbered with a narrow band, as column by column on a grid with few layers.
class BandedSolver final : public CheckedSolver {
 public:
  /// `ordering`: unknown number k of the band, shape n. Empty: the narrower of the natural order and reverse Cuthill-
  /// McKee.
  explicit BandedSolver(const SparsePattern& pattern, std::vector<Index> ordering = {});
  [[nodiscard]] std::string describe() const override;
  [[nodiscard]] std::string chosen() const override { return name; }
  static constexpr const char* name = "banded";
  /// Sub- and superdiagonals of the reordered matrix.
  [[nodiscard]] Index lower() const { return lower_; }
  [[nodiscard]] Index upper() const { return upper_; }
  /// Bytes of the band with room for pivoting.
  [[nodiscard]] std::size_t memory() const;
  /// Upper bound of the operations of a factorisation.
  [[nodiscard]] double flops_bound() const;

 protected:
  void factor_anew() override;
  void substitute(std::span<double> b) override;

 private:
  [[nodiscard]] Index leading() const { return 2 * lower_ + upper_ + 1; }

  std::string name_;
  std::vector<Index> order_, place_;  // unknown of each place, place of each unknown
  Index lower_ = 0, upper_ = 0;
  std::vector<double> band_, scratch_;
  std::vector<int> pivots_;
};

}  // namespace talus::linear
