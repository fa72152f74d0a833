#include "kinsol/kinsol.hpp"

#include <sundials/sundials_version.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "bridge/failure.hpp"
#include "core/errors.hpp"
#include "kinsol/continuation.hpp"
#include "kinsol/held_system.hpp"

namespace talus::kinsol {
namespace {

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

const Options& checked(const Options& options) {
  require(options.rtol > 0.0 && options.rtol < 1.0, "kinsol::Options: rtol must lie between 0 and 1");
  require(options.tolerance > 0.0, "kinsol::Options: tolerance must be positive");
  require(options.max_iterations > 0, "kinsol::Options: max_iterations must be positive");
  const auto& c = options.continuation;
  require(c.first_step > 0.0 && c.least_step > 0.0, "kinsol::Options: continuation steps must be positive");
  require(c.growth > 1.0, "kinsol::Options: continuation.growth must exceed 1");
  require(c.settled_below > 0.0, "kinsol::Options: continuation.settled_below must be positive");
  require(c.max_steps > 0 && c.max_iterations > 0, "kinsol::Options: limits of the continuation must be positive");
  return options;
}

}  // namespace

struct Kinsol::Parts {
  Parts(const core::DaeSystem& system, const Options& wanted)
      : options(checked(wanted)),
        held(system),
        equations(held, options.linear, statistics),
        newton(equations, options, statistics),
        continuation(newton, options, statistics),
        y(equations.size()),
        yp(equations.size(), 0.0) {}

  /// A guess that is not admissible fails in the solve that follows, which says why.
  void hold(double at) {
    try {
      held.hold(at, y);
    } catch (const core::InadmissibleState&) { held.release(); }
  }

  [[noreturn]] void fail(double at, const std::string& why, std::span<const double> state) {
    const auto size = newton.scaled_residual({at}, state);
    std::ostringstream what;
    what.precision(10);
    what << "KINSOL found no steady state (" << why << ") at t = " << at << " s, after " << statistics.newton_iterations
         << " iterations and " << statistics.restarts << " continuation steps";
    throw core::IntegrationError(bridge::report(
        {what.str(), equations.refusal(), "scaled residual of the steady state"}, equations.system(), size, state));
  }

  Options options;
  core::Statistics statistics;
  HeldSystem held;
  bridge::Equations equations;
  Newton newton;
  Continuation continuation;
  double t = 0.0;  // [s]
  std::vector<double> y, yp;
  bool started = false;
};

Kinsol::Kinsol(const core::DaeSystem& system, const Options& options)
    : parts_(std::make_unique<Parts>(system, options)) {}

Kinsol::~Kinsol() = default;

void Kinsol::start(double t, std::span<const double> y, std::span<const double> yp) {
  auto& p = *parts_;
  require(y.size() == p.y.size() && yp.size() == p.y.size(), "Kinsol::start: y and y' must have one value an unknown");
  p.statistics = {};
  p.equations.forget_refusal();
  p.t = t;
  std::copy(y.begin(), y.end(), p.y.begin());
  p.started = true;
}

void Kinsol::resume(const core::Snapshot& state, const std::string& linear_solver) {
  const core::Statistics statistics = state.statistics;
  parts_->equations.renew_solver(linear_solver);
  start(state.t, state.y, state.yp);
  parts_->statistics = statistics;
}

std::string Kinsol::linear_solver() const { return parts_->equations.solver().chosen(); }

bool Kinsol::advance(double t_out, core::Observer& observer) {
  auto& p = *parts_;
  if (!p.started) throw std::logic_error("Kinsol::advance before start");
  require(t_out >= p.t, "Kinsol::advance: cannot go back in time");
  std::vector<double> y = p.y;
  p.hold(t_out);
  if (!p.newton.solve({t_out}, y, p.options.max_iterations)) {
    const std::string why = p.newton.why();
    if (!p.options.continuation.allowed) p.fail(t_out, why, y);
    y = p.y;
    if (!p.continuation.run(t_out, y)) p.fail(t_out, why + "; then " + p.continuation.why(), y);
  }
  ++p.statistics.steps;
  p.t = t_out;
  p.y = std::move(y);
  observer.on_step(current());
  return true;
}

core::Snapshot Kinsol::current() const {
  const auto& p = *parts_;
  return {p.t, p.y, p.yp, p.statistics};
}

std::string Kinsol::describe() const {
  const auto& p = *parts_;
  std::array<char, 32> version{};
  SUNDIALSGetVersion(version.data(), static_cast<int>(version.size()));
  std::ostringstream line;
  line << "SUNDIALS KINSOL " << version.data() << ", Newton with line search";
  if (p.options.continuation.allowed) line << ", pseudo-transient continuation (" << p.statistics.restarts << " steps)";
  if (p.held.n_held() > 0) line << ", " << p.held.n_held() << " accumulators held";
  line << ", rtol " << p.options.rtol << "; " << p.equations.solver().describe();
  return line.str();
}

}  // namespace talus::kinsol
