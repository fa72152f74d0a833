#include "triangle/outflow.hpp"

#include <cmath>

#include "core/errors.hpp"
#include "steady/uniform_flow.hpp"

namespace talus::triangle {

Outflow outflow(const steady::Channel& channel, double tan_zeta, double thickness) {
  // Below this thickness Q, which falls as h^2.5, is far below what a double adds to any mass.
  constexpr double least_thickness = 1e-9;
  if (!(thickness > least_thickness) || !(tan_zeta > rheology::friction_at_rest(channel.law))) return {0.0, 0.0, 0.0};
  const auto flow = steady::UniformFlow::at_friction(channel, tan_zeta, thickness);
  if (!flow) throw core::InadmissibleState("the heap's face carries no steady flow: " + flow.reason());
  const double depth = flow->depth(), cosine = 1.0 / std::hypot(1.0, tan_zeta);
  const double shear_rate = flow->on_base() ? flow->inertial_number(-depth) / channel.grains.d *
                                                  std::sqrt(channel.grains.Phi * channel.gravity * cosine * depth)
                                            : 0.0;
  const double rho_W = channel.grains.rho() * channel.gap, rate = flow->flux();
  const double steeper = rho_W * channel.gap / channel.mu_w * (1.5 * flow->speed(0.0) - depth * shear_rate);
  return {rate, steeper - 0.5 * tan_zeta * cosine * cosine * rate, rho_W * depth * shear_rate};
}

}  // namespace talus::triangle
