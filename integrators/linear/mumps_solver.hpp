#pragma once

#include <memory>
#include <span>
#include <vector>

#include "linear/checked_solver.hpp"
#include "linear/mumps_factors.hpp"

namespace talus::linear {

/// MUMPS: multifrontal LU with dense blocks on a symmetrised pattern, for fields in the plane on large grids. It needs a diagonal
/// that is good on the whole. Where no more accuracy is asked for than `single_precision`, factors are made in single precision, which
/// takes half the memory and half the time; a matrix that is singular then, or whose first solve fails, is factored in double.
class MumpsSolver final : public CheckedSolver {
 public:
  explicit MumpsSolver(const SparsePattern& pattern);
  [[nodiscard]] std::string describe() const override;
  [[nodiscard]] std::string chosen() const override { return name; }
  static constexpr const char* name = "MUMPS";

 protected:
  void factor_anew() override;
  void substitute(std::span<double> b) override;
  [[nodiscard]] bool coarse() const override { return in_single_; }
  /// At 2.5 mm residuals were up to 4e-5 where the error, which is tested besides, was 3e-6.
  [[nodiscard]] double accept_coarse_below() const override { return 1e-4; }

 private:
  void scale_columns();
  template <class Real>
  void factor_in(std::unique_ptr<MumpsFactors<Real>>& factors);
  template <class Real>
  void substitute_in(MumpsFactors<Real>& factors, std::vector<Real>& scratch, std::span<double> b) const;

  bool in_single_ = false;            ///< the precision of the factors at hand
  std::vector<double> column_scale_;  ///< reciprocal of the largest entry of each column once rows are scaled, shape n
  std::unique_ptr<MumpsFactors<float>> single_;
  std::unique_ptr<MumpsFactors<double>> double_;
  std::vector<float> scratch_single_;
  std::vector<double> scratch_;
};

}  // namespace talus::linear
