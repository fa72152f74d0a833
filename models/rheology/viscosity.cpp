#include "rheology/viscosity.hpp"

#include <cmath>

#include "rheology/checks.hpp"

namespace talus::rheology {

void check(const Regularisation& reg) {
  const auto not_negative = [](const char* name, double value) {
    checks::require(std::isfinite(value) && value >= 0.0, "regularisation", name, value, "finite and at least 0");
  };
  not_negative("p_0", reg.p_0);
  not_negative("rate_floor", reg.rate_floor);
  not_negative("rate_speed", reg.rate_speed);
  if (reg.cap == Cap::none) checks::require(reg.eta_max > 0.0, "regularisation", "eta_max", reg.eta_max, "above 0");
  else checks::above(0.0, "regularisation", "eta_max", reg.eta_max);
}

bool is_capped(const Law& law, const Grains& grains, const Regularisation& reg, double D_norm_squared, double floor,
               double p) {
  if (reg.cap == Cap::none) return false;
  auto uncapped = reg;
  uncapped.cap = Cap::none;
  return viscosity(law, grains, reg, D_norm_squared, floor, p) <
         0.5 * viscosity(law, grains, uncapped, D_norm_squared, floor, p);
}

}  // namespace talus::rheology
