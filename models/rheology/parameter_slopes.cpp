#include "rheology/parameter_slopes.hpp"

#include <tuple>
#include <utility>

#include "rheology/well_posedness.hpp"

namespace talus::rheology {

// With l = I mu': q = mu - l/2, nu = l/mu, C = q^2 - 4 nu (1 - nu). The derivative of l is I d/dI of that of mu.
PosednessSlopes posedness_slopes(const Law& law, double I) {
  const Response r = response(law, I);
  const double log_slope = r.nu * r.mu;
  const auto slopes_from = [&](double by_mu, double by_l) {
    const double by_q = by_mu - 0.5 * by_l, by_nu = (by_l - r.nu * by_mu) / r.mu;
    return std::pair{2.0 * r.q * by_q - 4.0 * (1.0 - 2.0 * r.nu) * by_nu, by_q};
  };
  PosednessSlopes out{};
  const auto of_mu = parameter_slopes(law, core::Dual<1>::input(I, 0));
  for (int i = 0; i < n_law_parameters; ++i)
    std::tie(out.C[i], out.q[i]) = slopes_from(of_mu[i].value, I * of_mu[i].slope[0]);
  const auto l = friction_log_slope(law, core::Dual<1>::input(I, 0));
  std::tie(out.C_by_I, out.q_by_I) = slopes_from(log_slope / I, l.slope[0]);
  return out;
}

ByLawParameter<double> neutral_point_slopes(const Classical& base, double I_N) {
  const auto at = posedness_slopes(Law(base), I_N);
  ByLawParameter<double> out{};
  for (int i = 0; i < n_law_parameters; ++i) out[i] = -at.C[i] / at.C_by_I;
  return out;
}

}  // namespace talus::rheology
