#include "steady/channel.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "rheology/checks.hpp"

namespace talus::steady {

namespace {
void require(bool ok, const char* name, double value, const char* expected) {
  if (!ok)
    throw std::invalid_argument(std::string(name) + " = " + rheology::checks::text(value) + " must be " + expected);
}
}  // namespace

void check(const Channel& channel) {
  (void)rheology::grains(channel.grains.rho_star, channel.grains.Phi, channel.grains.d);
  require(std::isfinite(channel.gap) && channel.gap > 0.0, "gap", channel.gap, "finite and above 0 m");
  require(std::isfinite(channel.mu_w) && channel.mu_w >= 0.0, "mu_w", channel.mu_w, "finite and at least 0");
  require(std::isfinite(channel.gravity) && channel.gravity > 0.0, "gravity", channel.gravity,
          "finite and above 0 m/s2");
}

void check_layer(const Channel& channel, double zeta, double thickness) {
  check(channel);
  require(zeta > 0.0 && zeta < 0.5 * std::numbers::pi, "zeta", zeta, "above 0 and below pi/2 rad");
  require(thickness > 0.0, "thickness", thickness, "above 0 m");
  require(std::isfinite(thickness) || channel.mu_w > 0.0, "thickness", thickness,
          "finite where there is no wall friction (mu_w = 0)");
}

}  // namespace talus::steady
