#pragma once

#include <cmath>
#include <functional>

#include "layer/layer.hpp"
#include "support/taylor2.hpp"

namespace talus::tests {

/// A flow without divergence and its pressure, as functions of x, z [m] and t [s].
struct FlowAt {
  Taylor2 u, w, p;
};
using Flow = std::function<FlowAt(const Taylor2& x, const Taylor2& z, const Taylor2& t)>;

inline FlowAt flow_at(const Flow& flow, double x, double z, double t) {
  return flow(Taylor2::variable(x, Taylor2::x), Taylor2::variable(z, Taylor2::z), Taylor2::variable(t, Taylor2::t));
}

/// What a flow must be driven with so that it obeys the equations of motion, and its stress.
struct Balance {
  layer::Vector force;  ///< [N/m3]
  double tau_xx, tau_xz, eta;
};

/// What the balance depends on beside the flow. `viscosity` takes 4 D_norm^2 [1/s2] and p [Pa]; only values and first
/// derivatives of both are known.
struct Medium {
  double rho = 1.0;                   ///< [kg/m3]
  layer::Vector weight = {0.0, 0.0};  ///< [N/m3]
  std::function<Taylor2(const Taylor2& four_D_squared, const Taylor2& p)> viscosity;
  double wall_friction = 0.0;  ///< 2 mu_w/W [1/m]
  double u_s = 0.0;            ///< it acts as u/sqrt(|u|^2 + u_s^2) [m/s],
  double u_c = 0.0;            ///< times tanh(|u|/u_c) unless that is 0 [m/s]
};

/// Viscosity of grains under the partially regularised law, at I above I_N.
inline auto grain_viscosity(const rheology::PartiallyRegularised& law, const rheology::Grains& grains) {
  return [=](const Taylor2& four_D_squared, const Taylor2& p) {
    const auto two_D = sqrt(four_D_squared), I = grains.d * two_D / sqrt(p / grains.rho_star);
    return (law.mu_s * law.I_0 + law.mu_d * I + law.mu_inf * I * I) / (law.I_0 + I) * p / two_D;
  };
}

inline Balance balance_of(const FlowAt& f, const Medium& medium) {
  using enum Taylor2::By;
  const Taylor2 u_x = derivative(f.u, x), u_z = derivative(f.u, z), w_x = derivative(f.w, x);
  const Taylor2 shear = u_z + w_x;
  const Taylor2 eta = medium.viscosity(4.0 * u_x * u_x + shear * shear, f.p);
  const Taylor2 tau_xx = 2.0 * eta * u_x, tau_xz = eta * shear;
  const double speed = std::hypot(f.u.value, f.w.value, medium.u_s);
  const double turned_on = medium.u_c > 0.0 ? std::tanh(speed / medium.u_c) : 1.0;
  const double drag = speed > 0.0 ? medium.wall_friction * f.p.value * turned_on / speed : 0.0;
  const auto inertia = [&](const Taylor2& v) {
    return medium.rho * (v.first[t] + f.u.value * v.first[x] + f.w.value * v.first[z]);
  };
  return {{inertia(f.u) + f.p.first[x] - tau_xx.first[x] - tau_xz.first[z] - medium.weight.x + drag * f.u.value,
           inertia(f.w) + f.p.first[z] - tau_xz.first[x] + tau_xx.first[z] - medium.weight.z + drag * f.w.value},
          tau_xx.value,
          tau_xz.value,
          eta.value};
}

}  // namespace talus::tests
