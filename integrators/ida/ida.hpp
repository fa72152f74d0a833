#pragma once

#include <memory>

#include "core/dae_system.hpp"
#include "core/integrator.hpp"
#include "ida/options.hpp"

namespace talus::ida {

/// SUNDIALS IDA on a DaeSystem of index 1 or 2: backward differentiation formulas of variable order and step, with our
/// Newton iteration and our linear solvers.
///
/// Between breakpoints IDA chooses its steps freely; output times are reached by its own interpolation and disturb
/// nothing. At a breakpoint it stops, the state is made consistent again, and it starts afresh at order 1.
class Ida final : public core::Integrator {
 public:
  /// `system` must outlive this. Throws std::invalid_argument for options outside their range.
  explicit Ida(const core::DaeSystem& system, const Options& options = {});
  ~Ida() override;

  /// See core::Integrator. Throws IntegrationError where no consistent state is found, and what the system throws.
  void start(double t, std::span<const double> y, std::span<const double> yp) override;
  /// See core::Integrator; `observer.on_output` is the caller's to call, with current(). A step beyond t_out is shown
  /// to `observer.on_step` by the next call, so that observers see time grow. A request to stop at exactly t_out
  /// returns true.
  bool advance(double t_out, core::Observer& observer) override;
  [[nodiscard]] core::Snapshot current() const override;
  [[nodiscard]] std::string describe() const override;

  void resume(const core::Snapshot& state, const std::string& linear_solver) override;
  [[nodiscard]] std::string linear_solver() const override;

 private:
  void begin(const core::Snapshot& state);

  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace talus::ida
