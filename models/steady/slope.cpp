#include "steady/slope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/bracketed_root.hpp"
#include "rheology/checks.hpp"
#include "steady/layer_mean.hpp"

namespace talus::steady {

namespace {

using rheology::checks::text;
using Quantity = double (*)(const UniformFlow&);

constexpr double steepest_slope = 1e15;  ///< tan zeta, as near to 90 degrees as zeta can be told from it

/// What is looked for: the slope at which a quantity that grows with it has a value.
struct Search {
  const Channel& channel;
  double thickness;
  Quantity quantity;
  double value;

  /// Quantity over value, to a power that makes it nearly linear in the slope, less one.
  [[nodiscard]] double excess(double mu) const {
    const double bound = rheology::friction_bound(channel.law);
    double found = 0.0;
    if (mu <= rheology::friction_at_rest(channel.law)) return -1.0;
    if (mu >= bound) found = quantity(*UniformFlow::steepest(channel, thickness));
    else if (const auto flow = UniformFlow::at_friction(channel, mu, thickness)) found = quantity(*flow);
    return std::pow(found / value, 0.3) - 1.0;
  }

  /// tan zeta between `low` and `high`, or none where even `high` has too little. Searches outwards from a tenth above
  /// friction at rest, by factors: the slope may lie any number of orders above rest.
  [[nodiscard]] std::optional<double> run(double low, double high) const {
    const double rest = rheology::friction_at_rest(channel.law);
    double mu = std::clamp(rest + 0.1, low, high);
    const bool too_steep = excess(mu) > 0.0;
    while (true) {
      const double next = std::clamp(rest + (mu - rest) * (too_steep ? 0.125 : 8.0), low, high);
      const bool at_end = next == (too_steep ? low : high);
      if (too_steep ? at_end || excess(next) <= 0.0 : excess(next) >= 0.0)
        return core::bracketed_root([&](double m) { return excess(m); }, mu, next);
      if (at_end) return std::nullopt;
      mu = next;
    }
  }
};

/// The largest tan zeta that a search may try: the bound of the law itself where walls keep the limit finite.
double upper_end(const Channel& channel) {
  const double bound = rheology::friction_bound(channel.law);
  if (!std::isfinite(bound)) return steepest_slope;
  return channel.mu_w > 0.0 ? bound : std::nextafter(bound, 0.0);
}

std::string beyond(const Search& search, const std::string& what, const std::string& unit) {
  const double end = upper_end(search.channel);
  std::string reason = "no steady state: the " + what + " " + text(search.value) + " " + unit;
  if (end == steepest_slope) return reason + " needs a slope that cannot be told from 90 degrees";
  if (const auto limit = UniformFlow::steepest(search.channel, search.thickness))
    return reason + " exceeds the largest " + what + ", " + text(search.quantity(*limit)) + " " + unit +
           ", reached as tan zeta rises to mu_d = " + text(end) + " (" + in_degrees(end) + ")";
  return reason + " needs a slope that cannot be told from the steepest one, tan zeta = mu_d (" + in_degrees(end) + ")";
}

void check_target(const char* what, double value, const char* unit) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw std::invalid_argument(std::string(what) + " = " + text(value) + " must be finite and above 0 " + unit);
}

bool selects_speed(const rheology::Law& law) { return rheology::friction_bound(law) > rheology::friction_at_rest(law); }
Answer<UniformFlow> no_speed() {
  return Answer<UniformFlow>::none("no steady state: friction that does not grow with I does not select a speed");
}

}  // namespace

std::string in_degrees(double mu) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.6g degrees", std::atan(mu) * 180.0 / std::numbers::pi);
  return number.data();
}

Answer<UniformFlow> flow_of_flux(const Channel& channel, double Q, double thickness) {
  check_target("Q", Q, "kg/s");
  check_layer(channel, 0.5, thickness);
  if (!selects_speed(channel.law)) return no_speed();
  const Search search{channel, thickness, [](const UniformFlow& flow) { return flow.flux(); }, Q};
  const auto mu = search.run(rheology::friction_at_rest(channel.law), upper_end(channel));
  if (!mu) return Answer<UniformFlow>::none(beyond(search, "flux", "kg/s"));
  return UniformFlow::at_friction(channel, *mu, thickness);
}

Answer<double> slope_of_flux(const Channel& channel, double Q, double thickness) {
  const auto flow = flow_of_flux(channel, Q, thickness);
  return flow ? Answer<double>(flow->zeta()) : Answer<double>::none(flow.reason());
}

Answer<UniformFlow> flow_of_mean_speed(const Channel& channel, double speed, double thickness) {
  check_target("depth-averaged speed", speed, "m/s");
  check_layer(channel, 0.5, thickness);
  if (!selects_speed(channel.law)) return no_speed();
  const auto mean = [](const UniformFlow& flow) { return layer_mean(flow).speed; };
  const double rest = rheology::friction_at_rest(channel.law), end = upper_end(channel);
  // Up to this slope the flow ends above the base.
  const double reaches_base = std::min(rest + channel.mu_w / channel.gap * thickness, end);
  const Search free{channel, unbounded, mean, speed}, based{channel, thickness, mean, speed};
  std::optional<double> mu;
  if (channel.mu_w > 0.0) mu = free.run(rest, reaches_base);
  if (!mu && reaches_base < end) mu = based.run(reaches_base, end);
  if (!mu) return Answer<UniformFlow>::none(beyond(based, "depth-averaged speed", "m/s"));
  return UniformFlow::at_friction(channel, *mu, thickness);
}

std::optional<double> maximal_flux(const Channel& channel, double thickness) {
  check(channel);
  const auto limit = UniformFlow::steepest(channel, thickness);
  if (!limit) return std::nullopt;
  const auto* law = std::get_if<rheology::Classical>(&channel.law);
  if (!law) return limit->flux();
  const double h = limit->depth(), gradient = channel.mu_w / channel.gap, cos_d = 1.0 / std::hypot(1.0, law->mu_d);
  return channel.grains.rho() * channel.gap * law->I_0 / channel.grains.d *
         std::sqrt(channel.grains.Phi * channel.gravity * cos_d * h) * h *
         ((law->mu_d - law->mu_s) * (2.0 / 3.0) / gradient - 0.4 * h);
}

}  // namespace talus::steady
