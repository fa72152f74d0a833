#include "arkode/arkode.hpp"

#include <arkode/arkode_erkstep.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "bridge/equations.hpp"
#include "bridge/failure.hpp"
#include "bridge/vectors.hpp"
#include "core/errors.hpp"

namespace talus::arkode {

using bridge::view;

namespace {

void must(int flag, const char* call) {
  if (flag != ARK_SUCCESS) throw std::runtime_error(std::string(call) + " failed with flag " + std::to_string(flag));
}

struct Memory {
  SUNContext context = nullptr;
  void* erk = nullptr;

  Memory() {
    if (SUNContext_Create(nullptr, &context) != 0) throw std::bad_alloc();
  }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  ~Memory() {
    ERKStepFree(&erk);
    SUNContext_Free(&context);
  }
};

/// The factor of y_i' in its row, shape n.
std::vector<double> rate_factors(const core::DaeSystem& system) {
  const auto n = static_cast<std::size_t>(system.layout().size());
  for (core::Index i = 0; i < system.layout().size(); ++i)
    if (system.layout().field(i).kind != core::Kind::differential)
      throw std::invalid_argument("Arkode: " + system.describe(i) + " is algebraic, explicit methods need rates");
  const auto& pattern = system.pattern();
  std::vector<double> y(n), yp(n), with(pattern.n_nonzeros()), without(with.size()), factors(n);
  system.initial_state(0.0, y, yp);
  system.jacobian(0.0, y, yp, 1.0, with);
  system.jacobian(0.0, y, yp, 0.0, without);
  for (core::Index j = 0; j < pattern.n(); ++j)
    for (auto k = pattern.column_starts()[j]; k < pattern.column_starts()[j + 1]; ++k) {
      const double rate = with[k] - without[k];
      // What is left of a difference of two equal entries is rounding.
      const bool none = std::abs(rate) <= 1e-12 * std::abs(with[k]);
      if (pattern.rows()[k] == j) factors[j] = rate;
      else if (!none)
        throw std::invalid_argument("Arkode: the row of " + system.describe(pattern.rows()[k]) +
                                    " holds the rate of another unknown, " + system.describe(j));
    }
  for (std::size_t j = 0; j < n; ++j)
    if (factors[j] == 0.0)
      throw std::invalid_argument("Arkode: the row of " + system.describe(static_cast<core::Index>(j)) +
                                  " does not hold its rate");
  return factors;
}

}  // namespace

struct Arkode::Machine {
  Machine(const core::DaeSystem& system, const Options& wanted)
      : options(wanted),
        equations(system, {}, statistics),
        factors(rate_factors(system)),
        y(equations.size(), memory.context),
        tolerances(equations.size(), memory.context),
        yp(factors.size()),
        zero(factors.size(), 0.0) {
    if (!(options.rtol > 0.0 && options.rtol < 1.0) || options.order < 2 || options.order > 8 || options.max_steps < 1)
      throw std::invalid_argument("arkode::Options: rtol in (0, 1), order 2 to 8, max_steps 1 or more");
    for (core::Index i = 0; i < equations.size(); ++i)
      tolerances.span()[i] = system.layout().field(i).absolute_tolerance;
    memory.erk = ERKStepCreate(rates, 0.0, y.handle(), memory.context);
    if (memory.erk == nullptr) throw std::bad_alloc();
    must(ERKStepSetUserData(memory.erk, this), "ERKStepSetUserData");
    must(ERKStepSVtolerances(memory.erk, options.rtol, tolerances.handle()), "ERKStepSVtolerances");
    must(ERKStepSetOrder(memory.erk, options.order), "ERKStepSetOrder");
    must(ERKStepSetMaxNumSteps(memory.erk, -1), "ERKStepSetMaxNumSteps");
    must(ERKStepSetErrHandlerFn(memory.erk, keep_message, this), "ERKStepSetErrHandlerFn");
  }

  void begin(const core::Snapshot& state) {
    t = state.t;
    statistics = before = state.statistics;
    std::ranges::copy(state.y, y.span().begin());
    must(ERKStepReInit(memory.erk, rates, t, y.handle()), "ERKStepReInit");
    show();
  }

  void step(double t_out) {
    double stop = t_out;
    for (const double b : equations.system().breakpoints())
      if (b > t) stop = std::min(stop, b);
    must(ERKStepSetStopTime(memory.erk, stop), "ERKStepSetStopTime");
    const int flag = ERKStepEvolve(memory.erk, stop, y.handle(), &t, ARK_ONE_STEP);
    long n = 0;
    ERKStepGetNumSteps(memory.erk, &n);
    statistics.steps = before.steps + n;
    ERKStepGetNumErrTestFails(memory.erk, &n);
    statistics.error_test_failures = before.error_test_failures + n;
    ERKStepGetLastStep(memory.erk, &statistics.last_step);
    statistics.order = options.order;
    if (flag < 0) fail();
    show();
  }

  void fail() {
    equations.rethrow();
    std::ostringstream what;
    what << "ARKODE gave up (" << message << ") at t = " << t << " s after " << statistics.steps << " steps";
    const std::vector<double> no_measure(factors.size(), 0.0);
    throw core::IntegrationError(
        bridge::report({what.str(), equations.refusal(), "nothing"}, equations.system(), no_measure, y.span()));
  }

  void show() { static_cast<void>(rate(t, y.span(), yp)); }

  /// y' = -F(t, y, 0)/a.
  bridge::Outcome rate(double at, std::span<const double> state, std::span<double> result) {
    const auto outcome = equations.residual(at, state, zero, result);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] /= -factors[i];
    return outcome;
  }

  static int rates(realtype at, N_Vector state, N_Vector result, void* self) {
    return bridge::flag(static_cast<Machine*>(self)->rate(at, view(state), view(result)));
  }
  static void keep_message(int, const char*, const char*, char* text, void* self) {
    static_cast<Machine*>(self)->message = text;
  }

  Options options;
  core::Statistics statistics, before;
  bridge::Equations equations;
  std::vector<double> factors;
  Memory memory;
  bridge::Vector y, tolerances;
  std::vector<double> yp, zero;
  double t = 0.0;
  std::string message;
};

Arkode::Arkode(const core::DaeSystem& system, const Options& options)
    : machine_(std::make_unique<Machine>(system, options)) {}

Arkode::~Arkode() = default;

void Arkode::start(double t, std::span<const double> y, std::span<const double> /*yp*/) {
  if (y.size() != machine_->factors.size())
    throw std::invalid_argument("Arkode::start: y must have one value an unknown");
  machine_->begin({t, y, {}, {}});
}

void Arkode::resume(const core::Snapshot& state, const std::string& /*linear_solver*/) {
  core::Statistics statistics = state.statistics;
  ++statistics.restarts;
  machine_->begin({state.t, state.y, {}, statistics});
}

bool Arkode::advance(double t_out, core::Observer& observer) {
  auto& m = *machine_;
  if (t_out < m.t) throw std::invalid_argument("Arkode::advance: cannot go back in time");
  const auto first = m.statistics.steps;
  while (m.t < t_out) {
    if (m.statistics.steps - first >= m.options.max_steps) {
      m.message = "too many steps between two outputs";
      m.fail();
    }
    m.step(t_out);
    if (!observer.on_step(current()) && m.t < t_out) return false;
  }
  return true;
}

core::Snapshot Arkode::current() const { return {machine_->t, machine_->y.span(), machine_->yp, machine_->statistics}; }

std::string Arkode::describe() const {
  std::array<char, 32> version{};
  SUNDIALSGetVersion(version.data(), static_cast<int>(version.size()));
  std::ostringstream line;
  line << "SUNDIALS ARKODE " << version.data() << ", explicit Runge-Kutta of order " << machine_->options.order
       << ", rtol " << machine_->options.rtol;
  return line.str();
}

}  // namespace talus::arkode
