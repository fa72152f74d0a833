#include "ida/ida.hpp"

#include <sundials/sundials_version.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "ida/machine.hpp"

namespace talus::ida {

Ida::Ida(const core::DaeSystem& system, const Options& options)
    : machine_(std::make_unique<Machine>(system, options)) {}

Ida::~Ida() = default;

void Ida::start(double t, std::span<const double> y, std::span<const double> yp) {
  auto& m = *machine_;
  if (y.size() != m.shown_y.size() || yp.size() != m.shown_yp.size()) {
    throw std::invalid_argument("Ida::start: y and y' must have one value an unknown");
  }
  begin({t, y, yp, {}});
}

void Ida::resume(const core::Snapshot& state, const std::string& linear_solver) {
  machine_->equations.renew_solver(linear_solver);
  core::Statistics statistics = state.statistics;
  ++statistics.restarts;
  begin({state.t, state.y, state.yp, statistics});
}

std::string Ida::linear_solver() const { return machine_->equations.solver().chosen(); }

void Ida::begin(const core::Snapshot& state) {
  auto& m = *machine_;
  m.started = false;
  m.statistics = state.statistics;
  m.equations.forget_refusal();
  std::copy(state.y.begin(), state.y.end(), m.y.span().begin());
  std::copy(state.yp.begin(), state.yp.end(), m.yp.span().begin());
  m.begin(state.t);
  m.started = true;
}

bool Ida::advance(double t_out, core::Observer& observer) {
  auto& m = *machine_;
  if (!m.started) throw std::logic_error("Ida::advance before start");
  if (t_out < m.shown_t) throw std::invalid_argument("Ida::advance: cannot go back in time");
  while (true) {
    if (m.unseen && m.t <= t_out) {
      m.unseen = false;
      m.show_internal();
      if (!observer.on_step(current()) && m.t < t_out) return false;
    }
    if (m.t >= t_out) {
      m.interpolate(t_out);
      return true;
    }
    if (m.at_breakpoint) {
      ++m.statistics.restarts;
      m.begin(m.shown_t);
    }
    m.step(t_out);
  }
}

core::Snapshot Ida::current() const {
  const auto& m = *machine_;
  return {m.shown_t, m.shown_y, m.shown_yp, m.statistics};
}

std::string Ida::describe() const {
  const auto& m = *machine_;
  std::array<char, 32> version{};
  SUNDIALSGetVersion(version.data(), static_cast<int>(version.size()));
  std::ostringstream line;
  line << "SUNDIALS IDA " << version.data() << ", order <= " << m.options.max_order << ", rtol " << m.options.rtol
       << ", " << (m.damped ? "damped" : "stock") << " Newton; " << m.equations.solver().describe();
  return line.str();
}

}  // namespace talus::ida
