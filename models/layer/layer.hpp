#pragma once

#include "core/dae_system.hpp"
#include "fv/operator.hpp"
#include "layer/context.hpp"
#include "layer/unknowns.hpp"

namespace talus::layer {

/// The granular layer under a height function: (3.9) and (3.16) on a surface-fitted grid, with side-wall friction, a
/// traction-free surface at p = 0 or a rigid lid, a base, and a jet as a source of mass on the surface.
class Layer final : public core::DaeSystem {
 public:
  /// Throws std::invalid_argument for parameters outside their domain.
  explicit Layer(Parameters parameters);

  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return operator_->pattern(); }
  /// At rest under a lithostatic pressure, H = initial.thickness everywhere.
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override;
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override;
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override;
  [[nodiscard]] std::string describe(core::Index row) const override;
  [[nodiscard]] std::vector<double> breakpoints() const override;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] const grid::Columns& columns() const { return columns_; }
  [[nodiscard]] const Unknowns& unknowns() const { return unknowns_; }
  /// Heights of the grid for the thicknesses in y. Throws InadmissibleState where H is not positive and finite.
  [[nodiscard]] const Context& context(double t, std::span<const double> y) const;

 private:
  /// The speeds of the start, disturbed; `z`: heights of the interfaces.
  void set_speeds(std::span<const double> z, std::span<double> y) const;

  Parameters parameters_;
  grid::Columns columns_;
  grid::Layering layering_;
  Unknowns unknowns_;
  core::Layout layout_;
  mutable Context context_;
  std::unique_ptr<fv::Operator<Context>> operator_;
};

}  // namespace talus::layer
