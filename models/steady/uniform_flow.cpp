#include "steady/uniform_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/bracketed_root.hpp"
#include "rheology/checks.hpp"
#include "steady/quadrature.hpp"
#include "steady/slope.hpp"

namespace talus::steady {

namespace {

using rheology::checks::text;

/// How the inertial number falls with the friction m below `top`.
struct Bends {
  std::vector<double>
      at;      ///< descending: mu_d, where a small mu_inf takes over; mu(I_N); where the parabola at rest begins
  double end;  ///< where A exp(-alpha/m^2) has fallen by e^-60 below its largest value, or friction at rest
};
Bends bends(const rheology::Law& law, double top) {
  const auto* partial = std::get_if<rheology::PartiallyRegularised>(&law);
  if (!partial) return {{}, rheology::friction_at_rest(law)};
  const double creep = std::min(top, partial->friction_at_I_N()), parabola = partial->friction(partial->tiny_I);
  const double negligible = 1.0 / std::sqrt(1.0 / (creep * creep) + 60.0 / partial->alpha);
  std::vector<double> at{partial->mu_d, partial->friction_at_I_N(), parabola};
  std::erase_if(at, [&](double m) { return m >= top; });
  return {at, negligible > parabola ? negligible : 0.0};
}

/// Why tan zeta = `mu` has no steady state: the law's friction stays below it.
std::string too_steep(const Channel& channel, double mu, double thickness) {
  const double bound = rheology::friction_bound(channel.law);
  const bool partial = std::holds_alternative<rheology::PartiallyRegularised>(channel.law);
  std::string why = "tan zeta = " + text(mu) + " is not below " + text(bound) + " (" + in_degrees(bound) +
                    "), the largest friction of the " + std::string(rheology::name(channel.law)) + " law" +
                    (partial ? " with mu_inf = 0" : "");
  if (const auto flux = maximal_flux(channel, thickness))
    why += "; steady flow reaches up to Q_max = " + text(*flux) + " kg/s";
  return why;
}

}  // namespace

UniformFlow::UniformFlow(const Channel& channel, double zeta, double mu, double thickness)
    : channel_(channel),
      zeta_(zeta),
      tan_zeta_(mu),
      z_st_((rheology::friction_at_rest(channel.law) - mu) * channel.gap / channel.mu_w),
      depth_(std::min(-z_st_, thickness)),
      rate_(std::sqrt(channel.grains.Phi * channel.gravity / std::hypot(1.0, mu)) / channel.grains.d),
      gradient_(channel.mu_w / channel.gap) {}

Answer<UniformFlow> UniformFlow::at(const Channel& channel, double zeta, double thickness) {
  check_layer(channel, zeta, thickness);
  return with(channel, zeta, std::tan(zeta), thickness);
}

Answer<UniformFlow> UniformFlow::at_friction(const Channel& channel, double mu, double thickness) {
  check_layer(channel, std::atan(mu), thickness);
  return with(channel, std::atan(mu), mu, thickness);
}

Answer<UniformFlow> UniformFlow::with(const Channel& channel, double zeta, double mu, double thickness) {
  const auto none = [&](const std::string& why) { return Answer<UniformFlow>::none(why); };
  const double rest = rheology::friction_at_rest(channel.law);
  if (!(mu > rest))
    return none("at rest: tan zeta = " + text(mu) + " does not exceed the friction at rest, " + text(rest));
  if (mu >= rheology::friction_bound(channel.law)) return none("no steady state: " + too_steep(channel, mu, thickness));
  try {
    (void)rheology::inverse(channel.law, mu);
  } catch (const std::domain_error& e) { return none("no steady state at tan zeta = " + text(mu) + ": " + e.what()); }
  const UniformFlow flow(channel, zeta, mu, thickness);
  if (!flow.can_be_stated())
    return none("no flow that can be computed: at tan zeta = " + text(mu) + " with gap = " + text(channel.gap) +
                " m, mu_w = " + text(channel.mu_w) + ", d = " + text(channel.grains.d) +
                " m its speed or flux is outside 1e-280 to 1e+280");
  return flow;
}

bool UniformFlow::can_be_stated() const {
  const double speed = std::log10(rate_) + std::log10(inertial_number(0.0)) + 1.5 * std::log10(depth_);
  const double flux = speed + std::log10(depth_) + std::log10(channel_.grains.rho()) + std::log10(channel_.gap);
  return std::abs(speed) <= 280.0 && std::abs(flux) <= 280.0;
}

std::optional<UniformFlow> UniformFlow::steepest(const Channel& channel, double thickness) {
  const double bound = rheology::friction_bound(channel.law);
  if (!std::isfinite(bound) || !(bound > rheology::friction_at_rest(channel.law)) || channel.mu_w == 0.0)
    return std::nullopt;
  check_layer(channel, std::atan(bound), thickness);
  return UniformFlow(channel, std::atan(bound), bound, thickness);
}

double UniformFlow::friction(double z) const { return tan_zeta_ + gradient_ * z; }

double UniformFlow::inertial_number(double z) const {
  if (!(-z < -z_st_)) return 0.0;
  const double over_rest = tan_zeta_ - rheology::friction_at_rest(channel_.law);
  return rheology::inverse(channel_.law, tan_zeta_, std::min(-gradient_ * z, over_rest));
}

double UniformFlow::depth_of_inertial_number(double I) const {
  const double over = tan_zeta_ - rheology::friction(channel_.law, I);
  if (over <= 0.0) return 0.0;
  return gradient_ > 0.0 ? std::min(over / gradient_, depth_) : depth_;
}

UniformFlow::Edge UniformFlow::edge(double depth) const {
  const double rest = rheology::friction_at_rest(channel_.law);
  if (depth < -z_st_) return {std::sqrt(depth), tan_zeta_, std::min(gradient_ * depth, tan_zeta_ - rest)};
  return {std::sqrt(depth), rest, 0.0};
}

// With x = sqrt(-z) the integrand I 2 x^power is smooth at the surface for every slope, with or without walls: the 3/2
// power of the profile and of the flux is gone. Friction is counted from the nearer edge of the piece, where it is
// known exactly: near mu(0) and mu_d the inertial number hangs on its difference from them.
double UniformFlow::piece(int power, const Edge& top, const Edge& bottom) const {
  const double half = 0.5 * (bottom.x - top.x), rest = rheology::friction_at_rest(channel_.law);
  const auto integrand = [&](const Edge& edge, double from_edge) {
    const double x = edge.x + from_edge, less = edge.less + gradient_ * from_edge * (x + edge.x);
    return 2.0 * std::pow(x, power) *
           rheology::inverse(channel_.law, edge.friction, std::min(less, edge.friction - rest));
  };
  return integral([&](double y) { return integrand(top, y); }, 0.0, half) +
         integral([&](double y) { return integrand(bottom, -y); }, 0.0, half);
}

double UniformFlow::moment(int power, double from_depth, double to_depth) const {
  if (!(from_depth < to_depth)) return 0.0;
  Edge above = edge(from_depth), bottom = edge(to_depth);
  if (gradient_ == 0.0) return piece(power, above, bottom);
  const auto at_friction = [&](double m) { return Edge{std::sqrt((tan_zeta_ - m) / gradient_), m, 0.0}; };
  const auto [frictions, end] = bends(channel_.law, above.friction - above.less);
  if (end > bottom.friction - bottom.less) bottom = at_friction(end);
  double sum = 0.0;
  for (const double m : frictions) {
    if (m <= bottom.friction - bottom.less) break;
    const Edge bend = at_friction(m);
    sum += piece(power, above, bend);
    above = bend;
  }
  return sum + piece(power, above, bottom);
}

double UniformFlow::speed(double z) const {
  if (!(z <= 0.0)) throw std::invalid_argument("speed: z = " + text(z) + " must be at most 0 m");
  return rate_ * moment(2, -z, depth_);
}

std::vector<double> UniformFlow::speeds(std::span<const double> z) const {
  std::vector<std::size_t> upwards(z.size());
  std::iota(upwards.begin(), upwards.end(), 0);
  std::ranges::sort(upwards, {}, [&](std::size_t i) { return z[i]; });
  std::vector<double> u(z.size());
  double below = -depth_, sum = 0.0;
  for (const std::size_t i : upwards) {
    if (!(z[i] <= 0.0)) throw std::invalid_argument("speeds: z = " + text(z[i]) + " must be at most 0 m");
    if (z[i] > below) sum += rate_ * moment(2, -z[i], -below);
    u[i] = sum;
    below = std::max(below, z[i]);
  }
  return u;
}

// By parts: the integral of u from the surface to depth h is h u(h) + the integral of s |du/ds|.
double UniformFlow::volume_flux_above(double h) const {
  const double deep = std::min(h, depth_);
  return deep * speed(-deep) + rate_ * moment(4, 0.0, deep);
}

double UniformFlow::flux_above(double h) const { return channel_.grains.rho() * channel_.gap * volume_flux_above(h); }

double UniformFlow::depth_at_share(double share) const {
  if (!(share > 0.0 && share < 1.0)) throw std::invalid_argument("depth_at_share: the share must lie between 0 and 1");
  const double target = share * surface_speed();
  return core::bracketed_root([&](double s) { return speed(-s) - target; }, 0.0, depth_);
}

double UniformFlow::froude(double h) const {
  return mean_speed(h) / std::sqrt(channel_.gravity * h / std::hypot(1.0, tan_zeta_));
}

}  // namespace talus::steady
