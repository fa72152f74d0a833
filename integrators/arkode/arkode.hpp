#pragma once

#include <memory>

#include "core/dae_system.hpp"
#include "core/integrator.hpp"

namespace talus::arkode {

struct Options {
  double rtol = 1e-4;              ///< relative tolerance; absolute ones come with the fields
  int order = 4;                   ///< of the embedded Runge-Kutta pair, 2 to 8
  long max_steps = 1'000'000'000;  ///< between two outputs
};

/// SUNDIALS ARKODE's explicit Runge-Kutta methods (ERKStep) on a system whose rates stand alone, each in its own row:
/// a_i y_i' + G_i(t, y) = 0, a constant. A yardstick for the implicit integrators, not a way to run stiff systems.
class Arkode final : public core::Integrator {
 public:
  /// `system` must outlive this. Throws std::invalid_argument for options outside their range, and for a system with an
  /// algebraic unknown or with rates in rows of others.
  explicit Arkode(const core::DaeSystem& system, const Options& options = {});
  ~Arkode() override;

  /// See core::Integrator; `yp` is not read.
  void start(double t, std::span<const double> y, std::span<const double> yp) override;
  /// See core::Integrator: steps end at breakpoints and at t_out.
  bool advance(double t_out, core::Observer& observer) override;
  [[nodiscard]] core::Snapshot current() const override;
  void resume(const core::Snapshot& state, const std::string& linear_solver) override;
  /// None.
  [[nodiscard]] std::string linear_solver() const override { return ""; }
  [[nodiscard]] std::string describe() const override;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace talus::arkode
