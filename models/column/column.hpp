#pragma once

#include <memory>

#include "column/context.hpp"
#include "core/dae_system.hpp"
#include "fv/operator.hpp"

namespace talus::column {

/// A uniform layer over a base on which grains stick or slip, under a traction-free surface, with side-wall friction: (3.16) for u(z, t) alone
/// with lithostatic pressure. An ordinary differential equation with a tridiagonal Jacobian. Rows are in Pa.
class Column final : public core::DaeSystem {
 public:
  /// Throws std::invalid_argument for parameters outside their domain.
  explicit Column(Parameters parameters);

  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return operator_->pattern(); }
  /// The speeds of `start` and their rates.
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override;
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override;
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override;
  [[nodiscard]] std::string describe(core::Index row) const override;
  /// The kinks of the motion of the box.
  [[nodiscard]] std::vector<double> breakpoints() const override;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] const Heights& heights() const { return heights_; }
  [[nodiscard]] Context context(double t) const;

 private:
  Parameters parameters_;
  Heights heights_;
  core::Layout layout_;
  std::unique_ptr<fv::Operator<Context>> operator_;
};

}  // namespace talus::column
