#include "rheology/partially_regularised.hpp"

#include <stdexcept>
#include <string>

#include "rheology/checks.hpp"
#include "rheology/well_posedness.hpp"

namespace talus::rheology {

double PartiallyRegularised::inverse(double mu) const {
  if (!(mu >= 0.0)) checks::no_inverse(name, mu, "needs mu >= 0");
  if (mu > friction_at_I_N()) {
    // mu_inf I^2 + (mu_d - mu) I = I_0 (mu - mu_s); the form of the root that does not cancel.
    const double b = mu_d - mu, c = I_0 * (mu - mu_s);
    if (mu_inf == 0.0 && b <= 0.0)
      checks::no_inverse(name, mu, "with mu_inf = 0 needs mu < mu_d = " + checks::text(mu_d));
    const double root = std::sqrt(b * b + 4.0 * mu_inf * c);
    return b > 0.0 ? 2.0 * c / (b + root) : (root - b) / (2.0 * mu_inf);
  }
  if (mu > creep_limit()) return A * std::exp(-alpha / (mu * mu));
  // x (2 - n - (1 - n) x) = mu/creep_limit, smaller root.
  const double n = creep_power(), y = mu / creep_limit();
  return tiny_I * 2.0 * y / (2.0 - n + std::sqrt((2.0 - n) * (2.0 - n) - 4.0 * (1.0 - n) * y));
}

double creep_amplitude(const Classical& base, double mu_inf, double alpha, double I_N) {
  const double mu_N = (base.mu_s * base.I_0 + base.mu_d * I_N + mu_inf * I_N * I_N) / (base.I_0 + I_N);
  return I_N * std::exp(alpha / (mu_N * mu_N));
}

PartiallyRegularised partially_regularised(const Classical& base, double mu_inf, double alpha,
                                           std::optional<double> I_N) {
  constexpr auto law = PartiallyRegularised::name;
  const Classical checked = classical(base.mu_s, base.mu_d, base.I_0);
  checks::require(std::isfinite(mu_inf) && mu_inf >= 0.0, law, "mu_inf", mu_inf, "finite and at least 0");
  checks::above(0.0, law, "alpha", alpha);
  if (!I_N) {
    const auto neutral = neutral_points(checked);
    if (neutral.empty())
      throw std::invalid_argument(std::string(law) +
                                  ": I_N must be given: the classical curve is ill-posed at every I and has no"
                                  " neutral point");
    I_N = neutral.front();
  }
  checks::above(PartiallyRegularised::tiny_I, law, "I_N", *I_N);
  const double A = creep_amplitude(checked, mu_inf, alpha, *I_N);
  checks::require(A < 1e100, law, "alpha", alpha,
                  "small enough that A = I_N exp(alpha/mu(I_N)^2) (3.20) stays below 1e100");
  return {checked.mu_s, checked.mu_d, mu_inf, checked.I_0, *I_N, alpha, A};
}

}  // namespace talus::rheology
