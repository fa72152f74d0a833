#include "rheology/constant.hpp"

#include "rheology/checks.hpp"

namespace talus::rheology {

double Constant::inverse(double mu, double less) const {
  checks::no_inverse(name, mu - less, "every I has mu_s = " + checks::text(mu_s));
}

Constant constant(double mu_s) {
  checks::friction(Constant::name, "mu_s", mu_s);
  return {mu_s};
}

}  // namespace talus::rheology
