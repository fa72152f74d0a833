#include "rheology/well_posedness.hpp"

#include <cmath>
#include <limits>

namespace talus::rheology {

Response response(const Law& law, double I) {
  const double mu = friction(law, I);
  const double nu = mu > 0.0 ? friction_log_slope(law, I) / mu : 0.0;
  return {mu, nu, mu * (1.0 - 0.5 * nu)};
}

double condition_C(const Response& r) { return r.q * r.q - 4.0 * r.nu * (1.0 - r.nu); }

double growth(const Response& r, double s) { return ((r.q - (1.0 - r.nu) * s) * s - r.nu) / (1.0 - r.q * s); }

double max_growth(const Response& r) {
  if (!(std::abs(r.q) < 1.0)) return std::numeric_limits<double>::infinity();
  if (r.nu >= 1.0) return -1.0;
  const double c = std::sqrt((1.0 - r.q) * (1.0 + r.q));
  return (r.q * r.q / (1.0 + c) - 2.0 * r.nu) / (1.0 + c);
}

double worst_direction(const Response& r) {
  if (!(std::abs(r.q) < 1.0)) return 1.0 / r.q;
  if (r.nu > 1.0) return 1.0;
  return r.q / (1.0 + std::sqrt((1.0 - r.q) * (1.0 + r.q)));
}

WellPosedness well_posedness(const Response& r) {
  const bool outside = condition_C(r) > 0.0;
  if (!(std::abs(r.q) < 1.0) || (r.nu < 0.5 && outside)) return WellPosedness::ill_posed;
  return outside ? WellPosedness::damped : WellPosedness::well_posed;
}

double growth_scale(const Grains& grains, const Response& r, double I, double k) {
  const double kd_over_I = k * grains.d / I;
  return r.mu * kd_over_I * kd_over_I / grains.Phi;
}

}  // namespace talus::rheology
