#include "steady/uniform_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/bracketed_root.hpp"
#include "steady/quadrature.hpp"

namespace talus::steady {

namespace {

/// Where an integral over the friction m from `top` downwards may stop or must be split: at mu(I_N), and where the
/// creep A exp(-alpha/m^2) has fallen by e^-60 below its largest value.
struct Pieces {
  double split, end;
};
Pieces pieces(const rheology::Law& law, double top) {
  const auto* partial = std::get_if<rheology::PartiallyRegularised>(&law);
  if (!partial) return {rheology::friction_at_rest(law), rheology::friction_at_rest(law)};
  const double split = partial->friction_at_I_N();
  const double largest = std::min(top, split);
  return {split, 1.0 / std::sqrt(1.0 / (largest * largest) + 60.0 / partial->alpha)};
}

}  // namespace

UniformFlow::UniformFlow(const Channel& channel, double zeta, double thickness)
    : channel_(channel),
      zeta_(zeta),
      tan_zeta_(std::tan(zeta)),
      z_st_((rheology::friction_at_rest(channel.law) - tan_zeta_) * channel.gap / channel.mu_w),
      depth_(std::min(-z_st_, thickness)),
      rate_(std::sqrt(channel.grains.Phi * channel.gravity * std::cos(zeta)) / channel.grains.d),
      gradient_(channel.mu_w / channel.gap) {}

Answer<UniformFlow> UniformFlow::at(const Channel& channel, double zeta, double thickness) {
  check_layer(channel, zeta, thickness);
  const double mu = std::tan(zeta);
  if (!(mu > rheology::friction_at_rest(channel.law)))
    return Answer<UniformFlow>::none("at rest: tan zeta = " + std::to_string(mu) +
                                     " does not exceed the friction at rest, " +
                                     std::to_string(rheology::friction_at_rest(channel.law)));
  try {
    (void)rheology::inverse(channel.law, mu);
  } catch (const std::domain_error& e) {
    return Answer<UniformFlow>::none("no steady state at tan zeta = " + std::to_string(mu) + ": " + e.what());
  }
  return UniformFlow(channel, zeta, thickness);
}

double UniformFlow::friction(double z) const { return tan_zeta_ + gradient_ * z; }

double UniformFlow::inertial_number(double z) const {
  return -z < -z_st_ ? rheology::inverse(channel_.law, std::max(friction(z), rheology::friction_at_rest(channel_.law)))
                     : 0.0;
}

// With x = sqrt(-z) the integrand I 2 x^power is smooth at the surface for every slope, with or without walls: the 3/2
// power of the profile and of the flux is gone.
double UniformFlow::moment(int power, double from_depth, double to_depth) const {
  if (!(from_depth < to_depth)) return 0.0;
  const auto x_at = [&](double m) {
    const double s = m < tan_zeta_ ? (gradient_ > 0.0 ? (tan_zeta_ - m) / gradient_ : unbounded) : 0.0;
    return std::sqrt(std::clamp(s, from_depth, to_depth));
  };
  const auto f = [&](double x) { return 2.0 * std::pow(x, power) * inertial_number(-x * x); };
  const auto [split, end] = pieces(channel_.law, tan_zeta_ - gradient_ * from_depth);
  const double start = std::sqrt(from_depth);
  return integral(f, start, x_at(split)) + integral(f, x_at(split), x_at(end));
}

double UniformFlow::speed(double z) const {
  if (!(z <= 0.0)) throw std::invalid_argument("speed: z = " + std::to_string(z) + " must be at most 0 m");
  return rate_ * moment(2, -z, depth_);
}

std::vector<double> UniformFlow::speeds(std::span<const double> z) const {
  std::vector<double> u;
  u.reserve(z.size());
  for (const double each : z) u.push_back(speed(each));
  return u;
}

// By parts: the integral of u from the surface to depth h is h u(h) + the integral of s |du/ds|.
double UniformFlow::flux_above(double h) const {
  const double deep = std::min(h, depth_);
  return channel_.grains.rho() * channel_.gap * (deep * speed(-deep) + rate_ * moment(4, 0.0, deep));
}

double UniformFlow::depth_at_share(double share) const {
  if (!(share > 0.0 && share < 1.0)) throw std::invalid_argument("depth_at_share: the share must lie between 0 and 1");
  const double target = share * surface_speed();
  return core::bracketed_root([&](double s) { return speed(-s) - target; }, 0.0, depth_);
}

double UniformFlow::froude(double h) const {
  const double mean = flux_above(h) / (channel_.grains.rho() * channel_.gap * h);
  return mean / std::sqrt(channel_.gravity * h * std::cos(zeta_));
}

Answer<double> slope_of_flux(const Channel& channel, double Q, double thickness) {
  if (!(Q > 0.0 && std::isfinite(Q)))
    throw std::invalid_argument("slope_of_flux: Q = " + std::to_string(Q) + " must be above 0 kg/s");
  if (std::holds_alternative<rheology::Constant>(channel.law))
    return Answer<double>::none("no steady state: constant friction does not select a speed");
  const auto* classical = std::get_if<rheology::Classical>(&channel.law);
  const double rest = std::atan(rheology::friction_at_rest(channel.law));
  const double steepest = classical ? std::atan(classical->mu_d) * (1.0 - 1e-15) : 0.4999 * std::numbers::pi;
  // The power makes the flux nearly linear in the slope.
  const auto excess = [&](double zeta) {
    const auto flow = zeta > rest ? UniformFlow::at(channel, zeta, thickness) : Answer<UniformFlow>::none("");
    return std::pow(flow ? flow->flux() / Q : 0.0, 0.3) - 1.0;
  };
  if (excess(steepest) < 0.0)
    return Answer<double>::none("no steady state: Q = " + std::to_string(Q) + " kg/s exceeds the largest flux, " +
                                std::to_string(UniformFlow::at(channel, steepest, thickness)->flux()) + " kg/s");
  return core::bracketed_root(excess, std::max(rest, 1e-3), steepest);
}

std::optional<double> maximal_flux(const Channel& channel) {
  check(channel);
  const auto* law = std::get_if<rheology::Classical>(&channel.law);
  if (!law || channel.mu_w == 0.0) return std::nullopt;
  const double cos_d = 1.0 / std::hypot(1.0, law->mu_d);
  return channel.grains.rho() * channel.gap * law->I_0 / channel.grains.d *
         std::sqrt(channel.grains.Phi * channel.gravity * cos_d) * (4.0 / 15.0) *
         std::pow((law->mu_d - law->mu_s) * channel.gap / channel.mu_w, 2.5);
}

}  // namespace talus::steady
