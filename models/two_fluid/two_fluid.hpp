#pragma once

#include <memory>

#include "core/dae_system.hpp"
#include "fv/operator.hpp"
#include "two_fluid/context.hpp"
#include "two_fluid/unknowns.hpp"

namespace talus::two_fluid {

/// Grains and excess air in a fixed box: (5.4), (5.13) and (5.15) on a staggered grid, with side-wall friction, a base to which both
/// stick, open ends and an open top, and a dilute jet from an inlet in it.
class TwoFluid final : public core::DaeSystem {
 public:
  /// Throws std::invalid_argument for a grid without cells.
  explicit TwoFluid(Parameters parameters);

  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return operator_->pattern(); }
  /// At rest, a level layer of grains of the given thickness on the base, under hydrostatic pressure.
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override;
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override;
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override;
  [[nodiscard]] std::string describe(core::Index row) const override;
  [[nodiscard]] std::vector<double> breakpoints() const override;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Unknowns& unknowns() const { return unknowns_; }
  [[nodiscard]] Context context(double t) const;

 private:
  Parameters parameters_;
  Mesh mesh_;
  Unknowns unknowns_;
  core::Layout layout_;
  std::unique_ptr<fv::Operator<Context>> operator_;
};

}  // namespace talus::two_fluid
