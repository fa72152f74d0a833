#include "steady/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rheology/well_posedness.hpp"
#include "steady/slope.hpp"
#include "steady/vector_quadrature.hpp"

namespace talus::steady {

namespace {

using rheology::LawParameter;
using rheology::n_law_parameters;

constexpr int at(Parameter p) { return static_cast<int>(p); }
constexpr int at(LawParameter p) { return static_cast<int>(p); }

/// From derivatives by the law's own parameters, I_N among them, to those by what measurements may leave open.
void add_law(Gradient& by, const VariedChannel& varied, const rheology::ByLawParameter<double>& own) {
  for (int i = 0; i < at(LawParameter::I_N); ++i) by[i] += own[i];
  const auto* partial = std::get_if<rheology::PartiallyRegularised>(&varied.channel.law);
  if (!varied.I_N_follows || partial == nullptr) return;
  const auto I_N = rheology::neutral_point_slopes({partial->mu_s, partial->mu_d, partial->I_0}, partial->I_N);
  for (int i = 0; i < at(LawParameter::I_N); ++i) by[i] += own[at(LawParameter::I_N)] * I_N[i];
}

/// Integrals over I from 0 to that at a depth h, with s = (tan zeta - mu(I))/(mu_w/W) the depth where I rules: first of
/// s^power - h^power, then of s^(power - 1) and of that times each parameter slope of mu.
/// With I = top (1 - y^2) the half powers of s are smooth at the surface.
std::array<double, 2 + n_law_parameters> integrals(const Channel& channel, const UniformFlow& flow, double depth,
                                                   double power) {
  std::array<double, 2 + n_law_parameters> sum{};
  const double top = flow.inertial_number(-depth), gradient = channel.mu_w / channel.gap;
  if (!(top > 0.0)) return sum;
  const double mu_top = flow.friction(-depth), h_power = std::pow(depth, power);
  const auto integrand = [&](double y) {
    const double I = top * (1.0 - y) * (1.0 + y), weight = 2.0 * top * y;
    std::array<double, 2 + n_law_parameters> f{};
    if (!(I > rheology::PartiallyRegularised::tiny_I)) return f;
    const double s = depth + std::max(mu_top - rheology::friction(channel.law, I), 0.0) / gradient;
    const double s_less = weight * std::pow(s, power - 1.0);
    f[0] = weight * (std::pow(s, power) - h_power);
    f[1] = s_less;
    const auto slopes = rheology::parameter_slopes(channel.law, I);
    for (int i = 0; i < n_law_parameters; ++i) f[2 + i] = s_less * slopes[i];
    return f;
  };
  std::vector<double> edges{0.0, 1.0};
  if (const auto* partial = std::get_if<rheology::PartiallyRegularised>(&channel.law); partial && partial->I_N < top)
    edges.insert(edges.begin() + 1, std::sqrt(1.0 - partial->I_N / top));
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const auto part = vector_integral<2 + n_law_parameters>(integrand, edges[i], edges[i + 1]);
    std::ranges::transform(sum, part, sum.begin(), std::plus<>());
  }
  return sum;
}

/// How sqrt(Phi g cos zeta)/d changes, relative to itself, with tan zeta.
double rate_by_slope(double tan_zeta) { return -0.5 * tan_zeta / (1.0 + tan_zeta * tan_zeta); }

double rate(const Channel& c, const UniformFlow& flow) {
  return std::sqrt(c.grains.Phi * c.gravity / std::hypot(1.0, flow.tan_zeta())) / c.grains.d;
}

}  // namespace

bool uses(const rheology::Law& law, Parameter parameter) {
  if (parameter >= Parameter::mu_w || parameter == Parameter::mu_s) return true;
  if (std::holds_alternative<rheology::Constant>(law)) return false;
  if (parameter == Parameter::mu_d || parameter == Parameter::I_0) return true;
  return std::holds_alternative<rheology::PartiallyRegularised>(law);
}

Gradient VariedChannel::values() const {
  Gradient out{};
  if (const auto* constant = std::get_if<rheology::Constant>(&channel.law)) out[at(Parameter::mu_s)] = constant->mu_s;
  const auto classical = [&](const auto& law) {
    out[at(Parameter::mu_s)] = law.mu_s, out[at(Parameter::mu_d)] = law.mu_d, out[at(Parameter::I_0)] = law.I_0;
  };
  if (const auto* law = std::get_if<rheology::Classical>(&channel.law)) classical(*law);
  if (const auto* law = std::get_if<rheology::PartiallyRegularised>(&channel.law)) {
    classical(*law);
    out[at(Parameter::mu_inf)] = law->mu_inf, out[at(Parameter::alpha)] = law->alpha;
  }
  out[at(Parameter::mu_w)] = channel.mu_w, out[at(Parameter::W)] = channel.gap;
  out[at(Parameter::d)] = channel.grains.d, out[at(Parameter::Phi)] = channel.grains.Phi;
  out[at(Parameter::rho_star)] = channel.grains.rho_star;
  return out;
}

double value_of(const Channel& channel, Parameter parameter) { return VariedChannel{channel}.values()[at(parameter)]; }

VariedChannel VariedChannel::with(const Gradient& v) const {
  VariedChannel out = *this;
  Channel& c = out.channel;
  const auto of = [&](Parameter p) { return v[at(p)]; };
  c.grains = rheology::grains(of(Parameter::rho_star), of(Parameter::Phi), of(Parameter::d));
  c.gap = of(Parameter::W), c.mu_w = of(Parameter::mu_w);
  check(c);
  if (std::holds_alternative<rheology::Constant>(c.law)) {
    c.law = rheology::constant(of(Parameter::mu_s));
    return out;
  }
  const auto base = rheology::classical(of(Parameter::mu_s), of(Parameter::mu_d), of(Parameter::I_0));
  if (const auto* partial = std::get_if<rheology::PartiallyRegularised>(&c.law)) {
    const auto I_N = I_N_follows ? std::nullopt : std::optional(partial->I_N);
    c.law = rheology::partially_regularised(base, of(Parameter::mu_inf), of(Parameter::alpha), I_N);
  } else {
    c.law = base;
  }
  return out;
}

// (4.13) by parts, twice: Q = 2/5 rho W sqrt(Phi g cos zeta)/d times the integral of s^(5/2) dI, in which s vanishes at
// the upper end: parameters act through s and the factors alone.
Sensitivity flux_sensitivity(const VariedChannel& varied, const UniformFlow& flow) {
  const Channel& c = varied.channel;
  const auto sums = integrals(c, flow, 0.0, 2.5);
  const double factor = c.grains.rho() * c.gap * rate(c, flow), gradient = c.mu_w / c.gap, T = flow.tan_zeta();
  const double Q = 0.4 * factor * sums[0], by_excess = factor * sums[1] / gradient;
  Sensitivity out{Q, {}, by_excess + Q * rate_by_slope(T)};
  rheology::ByLawParameter<double> law{};
  for (int i = 0; i < n_law_parameters; ++i) law[i] = -factor * sums[2 + i] / gradient;
  add_law(out.by, varied, law);
  out.by[at(Parameter::mu_w)] = -2.5 * Q / c.mu_w;
  out.by[at(Parameter::W)] = 3.5 * Q / c.gap;
  out.by[at(Parameter::d)] = -Q / c.grains.d;
  out.by[at(Parameter::Phi)] = 1.5 * Q / c.grains.Phi;
  out.by[at(Parameter::rho_star)] = Q / c.grains.rho_star;
  return out;
}

// (4.12) by parts: u = 2/3 sqrt(Phi g cos zeta)/d times the integral of s^(3/2) - h^(3/2) dI up to I at the depth h.
Sensitivity speed_sensitivity(const VariedChannel& varied, const UniformFlow& flow, double depth) {
  const Channel& c = varied.channel;
  const auto sums = integrals(c, flow, depth, 1.5);
  const double factor = rate(c, flow), gradient = c.mu_w / c.gap, T = flow.tan_zeta();
  const double u = 2.0 / 3.0 * factor * sums[0], by_excess = factor * sums[1] / gradient;
  const double top = flow.inertial_number(-depth), root = std::sqrt(depth);
  Sensitivity out{u, {}, by_excess + u * rate_by_slope(T), -factor * top * root};
  rheology::ByLawParameter<double> law{};
  for (int i = 0; i < n_law_parameters; ++i) law[i] = -factor * sums[2 + i] / gradient;
  add_law(out.by, varied, law);
  const double by_log_gradient = -1.5 * u - factor * top * root * depth;
  out.by[at(Parameter::mu_w)] = by_log_gradient / c.mu_w;
  out.by[at(Parameter::W)] = -by_log_gradient / c.gap;
  out.by[at(Parameter::d)] = -u / c.grains.d;
  out.by[at(Parameter::Phi)] = 0.5 * u / c.grains.Phi;
  return out;
}

// mu(I; parameters) = tan zeta.
Sensitivity surface_inertial_number(const VariedChannel& varied, const UniformFlow& flow) {
  const double I = flow.inertial_number(0.0), slope = rheology::friction_slope(varied.channel.law, I);
  Sensitivity out{I, {}, 1.0 / slope};
  auto law = rheology::parameter_slopes(varied.channel.law, I);
  for (double& each : law) each /= -slope;
  add_law(out.by, varied, law);
  return out;
}

namespace {
Sensitivity through_surface(const VariedChannel& varied, const UniformFlow& flow, double value, double by_I,
                            const rheology::ByLawParameter<double>& law) {
  Sensitivity out = surface_inertial_number(varied, flow);
  out.value = value;
  out.by_slope *= by_I;
  for (double& each : out.by) each *= by_I;
  add_law(out.by, varied, law);
  return out;
}
}  // namespace

Sensitivity surface_C(const VariedChannel& varied, const UniformFlow& flow) {
  const double I = flow.inertial_number(0.0);
  const auto slopes = rheology::posedness_slopes(varied.channel.law, I);
  const double C = rheology::condition_C(rheology::response(varied.channel.law, I));
  return through_surface(varied, flow, C, slopes.C_by_I, slopes.C);
}

Sensitivity surface_q(const VariedChannel& varied, const UniformFlow& flow) {
  const double I = flow.inertial_number(0.0);
  const auto slopes = rheology::posedness_slopes(varied.channel.law, I);
  return through_surface(varied, flow, rheology::response(varied.channel.law, I).q, slopes.q_by_I, slopes.q);
}

// ln Q is nearly a straight line in the logarithm of the slope's excess over rest, whatever the law.
Answer<FlowWithFlux> flow_near(const VariedChannel& varied, double Q, std::optional<double> guess) {
  constexpr int most_steps = 8;
  const double rest = rheology::friction_at_rest(varied.channel.law);
  for (int step = 0; guess && step<most_steps&& * guess> rest; ++step) {
    const auto flow = UniformFlow::at_friction(varied.channel, *guess);
    if (!flow) break;
    const auto flux = flux_sensitivity(varied, *flow);
    const double off = std::log(flux.value / Q);
    if (std::abs(off) <= 1e-12) return FlowWithFlux{*flow, flux};
    guess = rest + (*guess - rest) * std::exp(-off * flux.value / (flux.by_slope * (*guess - rest)));
  }
  const auto flow = flow_of_flux(varied.channel, Q);
  if (!flow) return Answer<FlowWithFlux>::none(flow.reason());
  return FlowWithFlux{*flow, flux_sensitivity(varied, *flow)};
}

Sensitivity at_fixed_flux(const Sensitivity& any, const Sensitivity& flux) {
  Sensitivity out = any;
  for (int i = 0; i < n_parameters; ++i) out.by[i] -= any.by_slope * flux.by[i] / flux.by_slope;
  out.by_slope = 0.0;
  return out;
}

}  // namespace talus::steady
