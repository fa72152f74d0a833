#include "ida/machine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "bridge/failure.hpp"
#include "core/errors.hpp"
#include "ida/consistent_start.hpp"

namespace talus::ida {
namespace {

constexpr double never = 1e30;  // [s]

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

/// For calls that fail only by a mistake of ours.
void must(int flag, const char* call) {
  if (flag != IDA_SUCCESS) throw std::runtime_error(std::string(call) + " failed with flag " + std::to_string(flag));
}

std::string flag_name(int flag) {
  char* name = IDAGetReturnFlagName(flag);
  std::string copy(name);
  std::free(name);
  return copy;
}

const Options& checked(const Options& options) {
  require(options.rtol > 0.0 && options.rtol < 1.0, "ida::Options: rtol must lie between 0 and 1");
  require(options.max_order >= 1 && options.max_order <= 5, "ida::Options: max_order must be 1 to 5");
  require(options.initial_step >= 0.0 && options.max_step >= 0.0 && options.min_step >= 0.0,
          "ida::Options: steps must not be negative");
  require(options.start_step > 0.0, "ida::Options: start_step must be positive");
  require(options.newton.tolerance > 0.0, "ida::Options: newton.tolerance must be positive");
  require(options.max_failures_in_a_row > 0, "ida::Options: max_failures_in_a_row must be positive");
  return options;
}

}  // namespace

IdaMemory::IdaMemory() {
  if (SUNContext_Create(nullptr, &context) != 0) throw std::bad_alloc();
  ida = IDACreate(context);
  if (ida == nullptr) throw std::bad_alloc();
}

IdaMemory::~IdaMemory() {
  IDAFree(&ida);
  SUNContext_Free(&context);
}

Ida::Machine::Machine(const core::DaeSystem& system, const Options& wanted)
    : options(checked(wanted)),
      equations(system, options.linear, statistics),
      y(equations.size(), memory.context),
      yp(equations.size(), memory.context),
      tolerances(equations.size(), memory.context),
      kinds(equations.size(), memory.context),
      shown_y(equations.size()),
      shown_yp(equations.size()) {
  const auto& layout = system.layout();
  for (core::Index i = 0; i < layout.size(); ++i) {
    const auto& field = layout.field(i);
    tolerances.span()[i] = field.absolute_tolerance;
    kinds.span()[i] = field.kind == core::Kind::differential ? 1.0 : 0.0;
  }
  void* ida = memory.ida;
  must(IDASetErrHandlerFn(ida, keep_message, this), "IDASetErrHandlerFn");
  must(IDAInit(ida, residual, 0.0, y.handle(), yp.handle()), "IDAInit");
  must(IDASetUserData(ida, &equations), "IDASetUserData");
  must(IDASVtolerances(ida, options.rtol, tolerances.handle()), "IDASVtolerances");
  must(IDASetId(ida, kinds.handle()), "IDASetId");
  must(IDASetSuppressAlg(ida, options.suppress_algebraic ? SUNTRUE : SUNFALSE), "IDASetSuppressAlg");
  must(IDASetMaxOrd(ida, options.max_order), "IDASetMaxOrd");
  must(IDASetInitStep(ida, options.initial_step), "IDASetInitStep");
  must(IDASetMinStep(ida, options.min_step), "IDASetMinStep");
  if (options.max_step > 0.0) must(IDASetMaxStep(ida, options.max_step), "IDASetMaxStep");
  must(IDASetMaxNumSteps(ida, -1), "IDASetMaxNumSteps");
  must(IDASetMaxConvFails(ida, options.max_failures_in_a_row), "IDASetMaxConvFails");
  must(IDASetMaxErrTestFails(ida, options.max_failures_in_a_row), "IDASetMaxErrTestFails");
  must(IDASetNonlinConvCoef(ida, options.newton.tolerance), "IDASetNonlinConvCoef");
  if (options.newton.kind == Newton::damped) {
    damped = std::make_unique<StepNewton>(equations, options.newton, ida, memory.context);
    must(IDASetNonlinearSolver(ida, damped->handle()), "IDASetNonlinearSolver");
  } else {
    stock = std::make_unique<StockNewton>(equations, ida, y.handle(), memory.context);
  }
}

void Ida::Machine::begin(double from) {
  t = from;
  std::vector<double> correction;
  const auto outcome = make_consistent(equations, options, t, y.span(), yp.span(), correction);
  if (outcome != Outcome::ok) fail("no consistent state found", 0, correction);
  if (damped) damped->forget();
  before_ = statistics;
  must(IDAReInit(memory.ida, t, y.handle(), yp.handle()), "IDAReInit");
  set_stop_time(t);
  at_breakpoint = unseen = false;
  steps_since_output_ = 0;
  failures_at_output_ = statistics.error_test_failures + statistics.newton_failures;
  show_internal();
}

/// IDA 6.4.1 keeps a stop time that was reached, and cannot clear one: it is moved out of the way.
void Ida::Machine::set_stop_time(double from) {
  double stop = never;
  for (const double breakpoint : equations.system().breakpoints()) {
    if (breakpoint > from) stop = std::min(stop, breakpoint);
  }
  must(IDASetStopTime(memory.ida, stop), "IDASetStopTime");
}

void Ida::Machine::step(double t_out) {
  if (++steps_since_output_ > options.max_steps_between_outputs) fail("too many steps between two outputs", 0);
  // In one-step mode the time asked for matters for the size of the first step only.
  const double horizon = std::max({t_out - t, statistics.last_step, 1e-6});
  const int flag = IDASolve(memory.ida, t + horizon, &t, y.handle(), yp.handle(), IDA_ONE_STEP);
  count();
  if (flag < 0) fail("IDA gave up (" + flag_name(flag) + ": " + message_ + ")", flag);
  at_breakpoint = flag == IDA_TSTOP_RETURN;
  unseen = true;
  const long failures = statistics.error_test_failures + statistics.newton_failures - failures_at_output_;
  if (failures > options.max_failures_between_outputs)
    fail("too many failed steps between two outputs: no progress", 0);
}

void Ida::Machine::count() {
  long n = 0;
  void* ida = memory.ida;
  IDAGetNumSteps(ida, &n);
  statistics.steps = before_.steps + n;
  IDAGetNumErrTestFails(ida, &n);
  statistics.error_test_failures = before_.error_test_failures + n;
  IDAGetNumStepSolveFails(ida, &n);
  statistics.newton_failures = before_.newton_failures + n;
  IDAGetNumNonlinSolvIters(ida, &n);
  statistics.newton_iterations = before_.newton_iterations + n;
  IDAGetLastOrder(ida, &statistics.order);
  IDAGetLastStep(ida, &statistics.last_step);
}

void Ida::Machine::show_internal() {
  shown_t = t;
  std::copy(y.span().begin(), y.span().end(), shown_y.begin());
  std::copy(yp.span().begin(), yp.span().end(), shown_yp.begin());
}

void Ida::Machine::interpolate(double t_out) {
  if (t_out == t) {
    show_internal();
  } else if (t_out > shown_t) {
    const Vector v(equations.size(), memory.context);
    must(IDAGetDky(memory.ida, t_out, 0, v.handle()), "IDAGetDky");
    std::copy(v.span().begin(), v.span().end(), shown_y.begin());
    must(IDAGetDky(memory.ida, t_out, 1, v.handle()), "IDAGetDky");
    std::copy(v.span().begin(), v.span().end(), shown_yp.begin());
    shown_t = t_out;
  }
  steps_since_output_ = 0;
  failures_at_output_ = statistics.error_test_failures + statistics.newton_failures;
}

void Ida::Machine::fail(const std::string& what, int flag, std::span<const double> weighted_correction) {
  equations.rethrow();
  const auto n = static_cast<std::size_t>(equations.size());
  double step = 0.0;
  int order = 0;
  std::string measure;
  std::vector<double> size(n, 0.0);
  if (!weighted_correction.empty()) {
    measure = "weighted Newton correction of the start";
    std::copy(weighted_correction.begin(), weighted_correction.end(), size.begin());
  } else if (started) {
    IDAGetCurrentStep(memory.ida, &step);
    IDAGetCurrentOrder(memory.ida, &order);
    const Vector weights(equations.size(), memory.context), errors(equations.size(), memory.context);
    IDAGetErrWeights(memory.ida, weights.handle());
    IDAGetEstLocalErrors(memory.ida, errors.handle());
    const bool by_error = flag == IDA_ERR_FAIL;
    const bool by_newton = !by_error && damped && damped->newton().correction().size() == n;
    measure = by_error ? "weighted local error" : "weighted Newton correction";
    for (std::size_t i = 0; i < n; ++i) {
      const double change = by_newton ? damped->newton().correction()[i] : errors.span()[i];
      size[i] = by_error && kinds.span()[i] == 0.0 ? 0.0 : change * weights.span()[i];
    }
  }
  std::ostringstream headline;
  headline.precision(10);
  headline << what << " at t = " << t << " s, step " << step << " s, order " << order << ", after " << statistics.steps
           << " steps";
  const bridge::Failure failure{headline.str(), equations.refusal(), measure};
  throw core::IntegrationError(bridge::report(failure, equations.system(), size, shown_y));
}

int Ida::Machine::residual(realtype t, N_Vector y, N_Vector yp, N_Vector r, void* user) {
  return bridge::flag(static_cast<Equations*>(user)->residual(t, view(y), view(yp), view(r)));
}

void Ida::Machine::keep_message(int, const char*, const char*, char* message, void* user) {
  static_cast<Machine*>(user)->message_ = message;
}

}  // namespace talus::ida
