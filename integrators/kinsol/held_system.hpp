#pragma once

#include <vector>

#include "core/dae_system.hpp"

namespace talus::kinsol {

/// A system whose accumulators are held. An accumulator is an unknown that no row depends on, but for its rate in its own
/// row: mass poured in, for example. It has no steady state, and its column would make the Jacobian singular. Its row
/// becomes y_i = what it was, and the steady state of the others is the same.
class HeldSystem final : public core::DaeSystem {
 public:
  /// `system` must outlive this.
  explicit HeldSystem(const core::DaeSystem& system);

  /// Finds the accumulators and holds them at their values in y (shape n): columns with no entry but the diagonal, and
  /// none there for c_j = 0, at y and elsewhere. Throws what the system's Jacobian throws.
  void hold(double t, std::span<const double> y);
  void release();
  [[nodiscard]] std::size_t n_held() const { return held_.size(); }
  [[nodiscard]] bool holds(core::Index unknown) const;

  [[nodiscard]] const core::Layout& layout() const override { return system_.layout(); }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return system_.pattern(); }
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override {
    system_.initial_state(t, y, yp);
  }
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override;
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override;
  [[nodiscard]] std::string describe(core::Index row) const override { return system_.describe(row); }

 private:
  const core::DaeSystem& system_;
  std::vector<core::Index> alone_;  ///< unknowns whose column has no entry but the diagonal
  struct Held {
    core::Index unknown;
    double value;
  };
  std::vector<Held> held_;
  std::vector<core::Index> row_entries_;  ///< of the rows of held unknowns, as positions in the values
};

}  // namespace talus::kinsol
