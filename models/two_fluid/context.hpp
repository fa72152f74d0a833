#pragma once

#include <cmath>

#include "two_fluid/mesh.hpp"

namespace talus::two_fluid {

/// What all kernels share at one time.
struct Context {
  const Parameters* parameters;
  const Mesh* mesh;
  double t;                     ///< [s]
  double inlet_speed;           ///< of what is poured, normal to the base [m/s]
  double inlet_slip;            ///< along the base [m/s]
  double rate_floor;            ///< under D_norm [1/s]
  double gravity_x, gravity_z;  ///< [m/s2]
  double air_drag;              ///< of the side walls on air, a unit speed [kg/m3/s]

  [[nodiscard]] double rho_air() const { return parameters->numerics.air.rho; }
  /// Mass of grains a unit area between the side walls [kg/m2].
  [[nodiscard]] double grains_across() const { return parameters->grains.rho() * parameters->box.gap; }
  /// Scale of the time of a fall from the inlet [s].
  [[nodiscard]] double fall_time() const { return std::sqrt(parameters->box.height / parameters->box.gravity); }
  /// What grains weigh more than air [kg/m3].
  [[nodiscard]] double excess() const { return parameters->grains.rho() - rho_air(); }
  /// Mixture density (5.6) [kg/m3].
  template <class S>
  S density(const S& phi) const {
    return rho_air() + excess() * phi;
  }
  /// f_ga e (5.2) along x and z [m/s].
  [[nodiscard]] double segregation_x() const { return segregation() * direction_x(); }
  [[nodiscard]] double segregation_z() const { return segregation() * direction_z(); }

 private:
  [[nodiscard]] double segregation() const {
    const auto& n = parameters->numerics;
    return n.sharpening == Sharpening::segregation ? n.segregation_speed : 0.0;
  }
  [[nodiscard]] bool along_gravity() const { return parameters->numerics.direction != Direction::base_normal; }
  [[nodiscard]] double direction_x() const { return along_gravity() ? std::sin(parameters->box.tilt) : 0.0; }
  [[nodiscard]] double direction_z() const { return along_gravity() ? -std::cos(parameters->box.tilt) : -1.0; }
};

}  // namespace talus::two_fluid
