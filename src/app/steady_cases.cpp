#include "app/steady_cases.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/errors.hpp"
#include "rheology/checks.hpp"

namespace talus::app {
namespace {

using rheology::checks::text;
using steady::Answer;
using steady::UniformFlow;

constexpr double degree = std::numbers::pi / 180.0;

SteadyFlow describe(const UniformFlow& flow, const steady::PosednessBounds& bounds, int points) {
  SteadyFlow out{.flow = flow,
                 .surface_speed = flow.surface_speed(),
                 .flux = flow.flux(),
                 .half_depth = flow.depth_at_share(0.5),
                 .percent_depth = flow.depth_at_share(0.01),
                 .mean = steady::layer_mean(flow),
                 .posed = steady::ill_posed_depths(flow, bounds),
                 .depths = {},
                 .speeds = {}};
  std::vector<double> z;
  for (int i = 0; i < points; ++i) {
    out.depths.push_back(i + 1 == points ? flow.depth() : flow.depth() * i / (points - 1));
    z.push_back(-out.depths.back());
  }
  out.speeds = flow.speeds(z);
  return out;
}

Answer<UniformFlow> find(const steady::Channel& channel, double thickness, SteadyGiven given, double value) {
  switch (given) {
    case SteadyGiven::zeta: return UniformFlow::at(channel, value * degree, thickness);
    case SteadyGiven::flux: return steady::flow_of_flux(channel, value, thickness);
    case SteadyGiven::mean_speed: return steady::flow_of_mean_speed(channel, value, thickness);
  }
  throw std::logic_error("steady: nothing given");
}

void check_value(SteadyGiven given, double value) {
  if (given == SteadyGiven::zeta && !(value > 0.0 && value < 90.0))
    throw core::ConfigError("--zeta: " + text(value) + " must be above 0 and below 90 degrees");
  if (given == SteadyGiven::flux && !(value > 0.0))
    throw core::ConfigError("--Q: " + text(value) + " must be above 0 kg/s");
  if (given == SteadyGiven::mean_speed && !(value > 0.0))
    throw core::ConfigError("--depth-averaged-speed: " + text(value) + " must be above 0 m/s");
}

std::optional<rheology::Classical> classical_part(const rheology::Law& law) {
  if (const auto* classical = std::get_if<rheology::Classical>(&law)) return *classical;
  if (const auto* partial = std::get_if<rheology::PartiallyRegularised>(&law))
    return rheology::Classical{partial->mu_s, partial->mu_d, partial->I_0};
  return std::nullopt;
}

}  // namespace

SteadyStudy solve_steady(const steady::Channel& channel, double thickness, SteadyGiven given,
                         const std::vector<double>& values, int points) {
  if (channel.mu_w == 0.0 && !std::isfinite(thickness))
    throw core::ConfigError(
        "--thickness: needed where wall.mu_w = 0, for no wall friction ends the flow below: the layer's thickness over "
        "a "
        "no-slip base, above 0 m");
  SteadyStudy study{.channel = channel,
                    .thickness = thickness,
                    .given = given,
                    .points = static_cast<std::size_t>(points),
                    .bounds = steady::posedness_bounds(channel.law),
                    .maximal_flux = steady::maximal_flux(channel, thickness),
                    .maximal_classical_flux = std::nullopt,
                    .steepest = std::nullopt,
                    .cases = {}};
  if (const auto classical = classical_part(channel.law)) {
    steady::Channel other = channel;
    other.law = *classical;
    study.maximal_classical_flux = steady::maximal_flux(other, thickness);
  }
  const double bound = rheology::friction_bound(channel.law);
  if (std::isfinite(bound) && bound > rheology::friction_at_rest(channel.law)) study.steepest = std::atan(bound);
  for (const double value : values) {
    check_value(given, value);
    const auto flow = find(channel, thickness, given, value);
    study.cases.push_back({value, std::nullopt, flow.reason()});
    if (flow) study.cases.back().flow = describe(*flow, study.bounds, points);
  }
  return study;
}

}  // namespace talus::app
