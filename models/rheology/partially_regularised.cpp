#include "rheology/partially_regularised.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "rheology/checks.hpp"
#include "rheology/neutral_points.hpp"

namespace talus::rheology {

double PartiallyRegularised::inverse(double from, double less) const {
  const double mu = from - less;
  if (!(mu >= 0.0)) checks::no_inverse(name, mu, "needs mu >= 0");
  if (mu > mu_N) {
    // mu_inf I^2 + (mu_d - mu) I = I_0 (mu - mu_s); the form of the root that neither cancels nor overflows.
    const double b = (mu_d - from) + less, excess = (from - mu_s) - less;
    if (mu_inf == 0.0 && b <= 0.0)
      checks::no_inverse(name, mu, "with mu_inf = 0 needs mu < mu_d = " + checks::text(mu_d));
    const double root = std::hypot(b, 2.0 * std::sqrt(mu_inf) * std::sqrt(I_0) * std::sqrt(excess));
    const double I = b > 0.0 ? 2.0 * I_0 * (excess / (b + root)) : 0.5 * (root - b) / mu_inf;
    if (!std::isfinite(I)) checks::no_inverse(name, mu, "I would be above 1.8e308");
    return std::max(I, I_N);
  }
  if (mu > creep_limit()) return I_N * std::exp(-folds_N * (mu_N - mu) / mu * ((mu_N + mu) / mu));
  // x (2 - n - (1 - n) x) = mu/creep_limit, smaller root.
  const double n = creep_power(), y = mu / creep_limit();
  return tiny_I * 2.0 * y / (2.0 - n + std::sqrt((2.0 - n) * (2.0 - n) - 4.0 * (1.0 - n) * y));
}

PartiallyRegularised partially_regularised(const Classical& base, double mu_inf, double alpha,
                                           std::optional<double> I_N) {
  constexpr auto law = PartiallyRegularised::name;
  const Classical checked = classical(base.mu_s, base.mu_d, base.I_0);
  checks::require(mu_inf == 0.0 || (mu_inf >= checks::least && mu_inf <= checks::most_friction), law, "mu_inf", mu_inf,
                  "0, or from " + checks::text(checks::least) + " to " + checks::text(checks::most_friction));
  if (!I_N) {
    const auto neutral = neutral_points(checked);
    if (neutral.empty())
      throw std::invalid_argument(std::string(law) +
                                  ": I_N must be given: the classical curve is ill-posed at every I and has no"
                                  " neutral point");
    I_N = neutral.front();
  }
  checks::within(1e-150, 1e90, law, "I_N", *I_N);
  PartiallyRegularised made{checked.mu_s, checked.mu_d, mu_inf, checked.I_0, *I_N, alpha, 0.0, 0.0, 0.0};
  made.mu_N = made.rational(*I_N);
  const double mu_N_squared = made.mu_N * made.mu_N;
  const double low = 1e-50 * mu_N_squared, high = mu_N_squared * std::log(checks::most / *I_N);
  checks::require(alpha >= low && alpha <= high, law, "alpha", alpha,
                  "from " + checks::text(low) + " to " + checks::text(high) +
                      ", so that A = I_N exp(alpha/mu(I_N)^2) (3.20) is above I_N and at most 1e100");
  made.folds_N = alpha / mu_N_squared;
  made.A = *I_N * std::exp(made.folds_N);
  return made;
}

}  // namespace talus::rheology
