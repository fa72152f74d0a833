#pragma once

#include <ida/ida.h>
#include <sundials/sundials_context.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge/equations.hpp"
#include "bridge/vectors.hpp"
#include "ida/ida.hpp"
#include "ida/step_newton.hpp"
#include "ida/stock_newton.hpp"

namespace talus::ida {

/// A SUNContext and IDA's memory, released in the right order.
struct IdaMemory {
  SUNContext context = nullptr;
  void* ida = nullptr;

  IdaMemory();
  IdaMemory(const IdaMemory&) = delete;
  IdaMemory& operator=(const IdaMemory&) = delete;
  ~IdaMemory();
};

/// The parts of an Ida: SUNDIALS' objects and the state between calls.
struct Ida::Machine {
  Machine(const core::DaeSystem& system, const Options& options);

  /// Makes y, y' consistent at t and hands them to IDA.
  void begin(double from);
  /// One internal step, at most to the next breakpoint. Throws IntegrationError.
  void step(double t_out);
  /// Puts the state at t_out, which lies within the last step, into `shown`.
  void interpolate(double t_out);
  void show_internal();
  /// `weighted_correction`: of a start, shape n; empty for a step.
  [[noreturn]] void fail(const std::string& what, int flag, std::span<const double> weighted_correction = {});

  Options options;
  core::Statistics statistics;
  Equations equations;
  IdaMemory memory;
  Vector y, yp, tolerances, kinds;     // y, y' at the internal time t
  std::unique_ptr<StepNewton> damped;  // one of the two
  std::unique_ptr<StockNewton> stock;
  double t = 0.0;  // [s]
  bool started = false;
  bool at_breakpoint = false;  // t is one: start afresh before the next step
  bool unseen = false;         // the observer has not seen the step that ended at t
  double shown_t = 0.0;        // what current() tells
  std::vector<double> shown_y, shown_yp;

 private:
  void set_stop_time(double from);
  void count();

  static int residual(realtype t, N_Vector y, N_Vector yp, N_Vector r, void* user);
  static void keep_message(int code, const char* module, const char* function, char* message, void* user);

  core::Statistics before_;  // counts of IDA up to its last start
  std::string message_;      // IDA's last
  long steps_since_output_ = 0, failures_at_output_ = 0;
};

}  // namespace talus::ida
