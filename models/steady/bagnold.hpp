#pragma once

#include "steady/answer.hpp"
#include "steady/channel.hpp"

namespace talus::steady {

/// Bagnold's flow (appendix B): a layer over a no-slip base, without side walls, in closed form. I is the same at all
/// depths. z [m] is normal to the surface and zero on it.
class BagnoldFlow {
 public:
  /// zeta [rad], thickness h [m]; of the channel only grains, law and gravity. None where no I has mu(I) = tan zeta,
  /// or where tan zeta does not exceed mu(0). Throws std::invalid_argument on bad input.
  static Answer<BagnoldFlow> at(const Channel& channel, double zeta, double thickness);

  [[nodiscard]] double zeta() const { return zeta_; }
  [[nodiscard]] double thickness() const { return thickness_; }
  /// I with mu(I) = tan zeta.
  [[nodiscard]] double inertial_number() const { return I_; }
  /// du/dz [1/s] (B1).
  [[nodiscard]] double shear_rate(double z) const;
  /// u [m/s] (B2).
  [[nodiscard]] double speed(double z) const;
  [[nodiscard]] double surface_speed() const { return speed(0.0); }
  /// Mean over the depth [m/s], three fifths of the surface speed.
  [[nodiscard]] double mean_speed() const { return 0.6 * surface_speed(); }
  /// Mass flow a metre of width [kg/(m s)].
  [[nodiscard]] double flux() const { return rho_ * thickness_ * mean_speed(); }
  /// Mean speed over sqrt(g h cos zeta), (2 sqrt(Phi)/(5 d)) I h (A4).
  [[nodiscard]] double froude() const;

 private:
  BagnoldFlow(const Channel& channel, double zeta, double thickness);
  double zeta_, thickness_, I_, rho_, gravity_;
  double rate_;  ///< sqrt(Phi g cos zeta)/d [m^-1/2 s^-1]
};

}  // namespace talus::steady
