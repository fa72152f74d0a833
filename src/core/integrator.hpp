#pragma once

#include <span>
#include <string>

#include "core/statistics.hpp"

namespace talus::core {

/// What an observer sees after a step or at an output time. Spans are valid during the call only.
struct Snapshot {
  double t;                    ///< [s]
  std::span<const double> y;   ///< shape n
  std::span<const double> yp;  ///< shape n
  const Statistics& statistics;
};

/// Watches an integration without touching it.
class Observer {
 public:
  virtual ~Observer() = default;
  /// After each accepted internal step. Return false to ask for an early, clean stop.
  virtual bool on_step(const Snapshot&) { return true; }
  /// At each requested output time, exactly there.
  virtual void on_output(const Snapshot&) {}
};

/// Advances one DaeSystem in time.
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Begins at time t [s] from state y with derivative guess yp (shape n each) and makes them consistent.
  virtual void start(double t, std::span<const double> y, std::span<const double> yp) = 0;
  /// Integrates to exactly t_out [s], calling `observer.on_step` on the way. False if the observer asked to stop: then the
  /// current time is below t_out. Throws IntegrationError.
  virtual bool advance(double t_out, Observer& observer) = 0;
  [[nodiscard]] virtual Snapshot current() const = 0;
  /// Starts afresh at a checkpoint: from `state`, which current() of this or of another such integrator on the same system
  /// gave, and `linear_solver` of the same moment; goes on counting from its statistics. What follows depends on these two
  /// alone: a run continued from a checkpoint and the run that wrote it, both having come through here, are equal bit by
  /// bit.
  virtual void resume(const Snapshot& state, const std::string& linear_solver) = 0;
  /// The linear solver and ordering that trials on the first matrix came to; "" before it.
  [[nodiscard]] virtual std::string linear_solver() const = 0;
  /// One line naming integrator, linear solver, ordering and their versions.
  [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace talus::core
