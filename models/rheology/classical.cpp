#include "rheology/classical.hpp"

#include <cmath>

#include "rheology/checks.hpp"

namespace talus::rheology {

double Classical::inverse(double mu, double less) const {
  if (mu_s == mu_d) checks::no_inverse(name, mu - less, "every I has mu_s = mu_d = " + checks::text(mu_s));
  const double above = (mu - mu_s) - less, below = (mu_d - mu) + less;
  if (!(above >= 0.0 && below > 0.0))
    checks::no_inverse(name, mu - less, "needs mu_s = " + checks::text(mu_s) + " <= mu < mu_d = " + checks::text(mu_d));
  return I_0 * (above / below);
}

Classical classical(double mu_s, double mu_d, double I_0) {
  checks::friction(Classical::name, "mu_s", mu_s);
  checks::friction(Classical::name, "mu_d", mu_d);
  checks::require(mu_d >= mu_s, Classical::name, "mu_d", mu_d,
                  "at least mu_s = " + checks::text(mu_s) + ", or friction would fall as I grows");
  checks::within(checks::least, checks::most, Classical::name, "I_0", I_0);
  return {mu_s, mu_d, I_0};
}

}  // namespace talus::rheology
