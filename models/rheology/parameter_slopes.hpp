#pragma once

#include <array>

#include "rheology/law.hpp"

namespace talus::rheology {

/// The parameters of the laws of this room, each law using some of them.
enum class LawParameter { mu_s, mu_d, mu_inf, I_0, alpha, I_N };
inline constexpr int n_law_parameters = 6;

/// A number for each law parameter, in the order of `LawParameter`; zero for those that a law does not use.
template <class S>
using ByLawParameter = std::array<S, n_law_parameters>;

namespace parameter_slopes_of {

template <class S>
ByLawParameter<S> law(const Constant&, const S&) {
  return {S(1.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0)};
}

template <class S>
ByLawParameter<S> law(const Classical& c, const S& I) {
  const S share = saturation(I, c.I_0);
  return {1.0 - share, share, S(0.0), -1.0 * (c.mu_d - c.mu_s) * share / (I + c.I_0), S(0.0), S(0.0)};
}

/// Of the branch above I_N.
template <class S>
ByLawParameter<S> rational(const PartiallyRegularised& p, const S& I) {
  const S share = saturation(I, p.I_0);
  return {1.0 - share, share, I * share, -1.0 * (p.mu_d - p.mu_s + p.mu_inf * I) * share / (I + p.I_0), S(0.0), S(0.0)};
}

/// Creep is 1/mu^2 = 1/mu_N^2 + ln(I_N/I)/alpha with mu_N = mu(I_N) of the branch above.
template <class S>
ByLawParameter<S> creep(const PartiallyRegularised& p, const S& I) {
  using std::log;
  using core::log;
  const S mu = p.friction(I), cube = mu * mu * mu;
  const auto at_I_N = rational(p, core::Dual<1>::input(p.I_N, 0));
  const double mu_N_cubed = p.mu_N * p.mu_N * p.mu_N;
  ByLawParameter<S> slopes;
  for (int i = 0; i < n_law_parameters; ++i) slopes[i] = cube * (at_I_N[i].value / mu_N_cubed);
  slopes[static_cast<int>(LawParameter::alpha)] = cube * log(p.I_N / I) * (0.5 / (p.alpha * p.alpha));
  const double slope_N = p.rational(core::Dual<1>::input(p.I_N, 0)).slope[0];
  slopes[static_cast<int>(LawParameter::I_N)] = cube * (slope_N / mu_N_cubed - 0.5 / (p.alpha * p.I_N));
  return slopes;
}

template <class S>
ByLawParameter<S> law(const PartiallyRegularised& p, const S& I) {
  return core::value_of(I) > p.I_N ? rational(p, I) : creep(p, I);
}

}  // namespace parameter_slopes_of

/// Partial derivatives of mu(I) with respect to the law's parameters, at fixed I; I_N counts as one of its own. S: double
/// or Dual. At I_N those of the creep side. Precondition: I > 0, and above `tiny_I` of a law that has it.
template <class S>
ByLawParameter<S> parameter_slopes(const Law& law, const S& I) {
  return std::visit([&](const auto& l) { return parameter_slopes_of::law(l, I); }, law);
}

/// Partial derivatives of C (3.18) and of q at fixed I, likewise.
struct PosednessSlopes {
  ByLawParameter<double> C, q;
  double C_by_I, q_by_I;
};
[[nodiscard]] PosednessSlopes posedness_slopes(const Law& law, double I);

/// Total derivatives of I_N where it is the lower neutral point of `base`, as `partially_regularised` takes it.
[[nodiscard]] ByLawParameter<double> neutral_point_slopes(const Classical& base, double I_N);

}  // namespace talus::rheology
