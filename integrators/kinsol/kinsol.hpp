#pragma once

#include <memory>

#include "core/dae_system.hpp"
#include "core/integrator.hpp"
#include "kinsol/options.hpp"

namespace talus::kinsol {

/// Steady states F(t, y, 0) = 0 of a DaeSystem, by SUNDIALS KINSOL: Newton's method with line search, then, where that
/// does not converge, pseudo-transient continuation. A sequence of output times gives a sequence of quasi-steady
/// states, each sought from the one before.
///
/// In the statistics `steps` counts steady states, `restarts` continuation steps, `newton_failures` solves that failed.
class Kinsol final : public core::Integrator {
 public:
  /// `system` must outlive this. Throws std::invalid_argument for options outside their range.
  explicit Kinsol(const core::DaeSystem& system, const Options& options = {});
  ~Kinsol() override;

  /// Takes y as the guess; yp is not used. Nothing is solved before advance().
  void start(double t, std::span<const double> y, std::span<const double> yp) override;
  /// Puts the steady state of t_out, from the state at hand, into current() and shows it to `observer.on_step`. Returns
  /// true. Throws IntegrationError, and what the system throws; current() is then as before.
  bool advance(double t_out, core::Observer& observer) override;
  /// y' is zero.
  [[nodiscard]] core::Snapshot current() const override;
  [[nodiscard]] std::string describe() const override;
  void resume(const core::Snapshot& state, const std::string& linear_solver) override;
  [[nodiscard]] std::string linear_solver() const override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::kinsol
