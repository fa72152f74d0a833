#include "steady/bagnold.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "steady/uniform_flow.hpp"

namespace talus::steady {

BagnoldFlow::BagnoldFlow(const Channel& channel, double zeta, double thickness)
    : zeta_(zeta),
      thickness_(thickness),
      I_(rheology::inverse(channel.law, std::tan(zeta))),
      rho_(channel.grains.rho()),
      gravity_(channel.gravity),
      rate_(std::sqrt(channel.grains.Phi * channel.gravity * std::cos(zeta)) / channel.grains.d) {}

Answer<BagnoldFlow> BagnoldFlow::at(const Channel& channel, double zeta, double thickness) {
  Channel open = channel;
  open.mu_w = 0.0;
  const auto flow = UniformFlow::at(open, zeta, thickness);
  if (!flow) return Answer<BagnoldFlow>::none(flow.reason());
  return BagnoldFlow(open, zeta, thickness);
}

double BagnoldFlow::shear_rate(double z) const { return I_ * rate_ * std::sqrt(-z); }

double BagnoldFlow::speed(double z) const {
  if (!(z <= 0.0 && z >= -thickness_))
    throw std::invalid_argument("speed: z = " + std::to_string(z) + " must lie within the layer, from " +
                                std::to_string(-thickness_) + " to 0 m");
  // 1.5th powers cancel near the base: h^1.5 - s^1.5 = (h - s) (h + sqrt(h s) + s)/(sqrt(h) + sqrt(s)).
  const double h = thickness_, s = -z;
  return (2.0 / 3.0) * I_ * rate_ * (h - s) * ((h + std::sqrt(h * s) + s) / (std::sqrt(h) + std::sqrt(s)));
}

double BagnoldFlow::froude() const { return mean_speed() / std::sqrt(gravity_ * thickness_ * std::cos(zeta_)); }

}  // namespace talus::steady
