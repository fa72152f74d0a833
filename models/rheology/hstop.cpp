#include "rheology/hstop.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "rheology/checks.hpp"

namespace talus::rheology {

namespace {

constexpr auto what = "h_stop";

/// I_0 L of (A6).
double product(double beta, const Grains& grains) {
  checks::within(checks::least, checks::most, what, "beta", beta);
  return 2.5 * beta * grains.d / std::sqrt(grains.Phi);
}

}  // namespace

double HstopCurve::thickness(double zeta) const {
  const double mu = std::tan(zeta);
  if (!(mu > mu_s)) return std::numeric_limits<double>::infinity();
  return mu < mu_d ? length * ((mu_d - mu) / (mu - mu_s)) : 0.0;
}

HstopCurve hstop_curve(double mu_s, double mu_d, double length) {
  checks::friction(what, "mu_s", mu_s);
  checks::friction(what, "mu_d", mu_d);
  checks::require(mu_d > mu_s, what, "mu_d", mu_d,
                  "above mu_s = " + checks::text(mu_s) + ": thinner deposits lie on steeper slopes");
  checks::within(checks::least, checks::most, what, "L", length);
  return {mu_s, mu_d, length};
}

Classical classical_of(const HstopCurve& curve, double beta, const Grains& grains) {
  return classical(curve.mu_s, curve.mu_d, product(beta, grains) / curve.length);
}

HstopCurve hstop_of(const Classical& law, double beta, const Grains& grains) {
  return hstop_curve(law.mu_s, law.mu_d, product(beta, grains) / law.I_0);
}

}  // namespace talus::rheology
