#pragma once

#include <cmath>

#include "two_fluid/mesh.hpp"

namespace talus::two_fluid {

/// What all kernels share at one time.
struct Context {
  const Parameters* parameters;
  const Mesh* mesh;
  double t;                             ///< [s]
  double inlet_speed;                   ///< of what is poured, normal to the base [m/s]
  double inlet_slip;                    ///< along the base [m/s]
  double poured;                        ///< volume of grains a unit time and gap [m2/s]
  double fall_x, fall_z;                ///< unit vector along which grains fall from the inlet [1]
  double rate_floor;                    ///< under D_norm [1/s]
  double gravity_x, gravity_z;          ///< [m/s2]
  double segregation_x, segregation_z;  ///< f_ga e (5.2) [m/s]
  double air_drag;                      ///< of the side walls on air, a unit speed [kg/m3/s]

  [[nodiscard]] double rho_air() const { return parameters->numerics.air.rho; }
  /// Mass of grains a unit area between the side walls [kg/m2].
  [[nodiscard]] double grains_across() const { return parameters->grains.rho() * parameters->box.gap; }
  /// Scale of the time of a fall from the inlet [s].
  [[nodiscard]] double fall_time() const { return std::sqrt(parameters->box.height / parameters->box.gravity); }
  /// Speed of grains in free fall after a drop from the inlet [m/s].
  [[nodiscard]] double fall_speed(double drop) const {
    return std::sqrt(inlet_speed * inlet_speed + inlet_slip * inlet_slip + 2.0 * parameters->box.gravity * drop);
  }
  /// What grains weigh more than air [kg/m3].
  [[nodiscard]] double excess() const { return parameters->grains.rho() - rho_air(); }
  /// Mixture density (5.6) [kg/m3].
  template <class S>
  S density(const S& phi) const {
    return rho_air() + excess() * phi;
  }
};

}  // namespace talus::two_fluid
