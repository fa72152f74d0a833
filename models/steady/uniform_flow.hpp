#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "steady/answer.hpp"
#include "steady/channel.hpp"

namespace talus::steady {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The exact steady uniform flow down a surface of slope zeta between walls (paper section 4), on a heap or over a
/// no-slip base. z [m] is normal to the surface and zero on it, negative below. Where nothing flows the speed is zero.
class UniformFlow {
 public:
  /// zeta [rad]; thickness [m] of the layer over its no-slip base, unbounded for a heap. With mu_w = 0 this is
  /// Bagnold's flow (B2). None where the law has no friction tan zeta, or where that does not exceed mu(0). Throws
  /// std::invalid_argument on bad input.
  static Answer<UniformFlow> at(const Channel& channel, double zeta, double thickness = unbounded);

  [[nodiscard]] double zeta() const { return zeta_; }
  /// (4.9) [m]: below it nothing flows; -infinity without wall friction.
  [[nodiscard]] double z_st() const { return z_st_; }
  /// The flowing depth [m]: -z_st, or the thickness where that is less.
  [[nodiscard]] double depth() const { return depth_; }
  /// mu (4.8) in the flowing depth.
  [[nodiscard]] double friction(double z) const;
  /// I (4.11); zero below z_st.
  [[nodiscard]] double inertial_number(double z) const;
  /// u [m/s], the integral of (4.12). Relative error below 1e-10, also where u is many orders below the surface speed.
  [[nodiscard]] double speed(double z) const;
  [[nodiscard]] std::vector<double> speeds(std::span<const double> z) const;
  [[nodiscard]] double surface_speed() const { return speed(0.0); }
  /// Q (4.13) [kg/s].
  [[nodiscard]] double flux() const { return flux_above(depth_); }
  /// The part of Q [kg/s] that flows within `h` [m] of the surface.
  [[nodiscard]] double flux_above(double h) const;
  /// Depth [m], positive, at which the speed is `share` (0..1) of the surface speed.
  [[nodiscard]] double depth_at_share(double share) const;
  /// Mean speed within `h` [m] of the surface over sqrt(g h cos zeta). The creeping tail makes `depth()` a poor h.
  [[nodiscard]] double froude(double h) const;

 private:
  UniformFlow(const Channel& channel, double zeta, double thickness);
  [[nodiscard]] double moment(int power, double from_depth, double to_depth) const;

  Channel channel_;
  double zeta_, tan_zeta_, z_st_, depth_;
  double rate_;      ///< sqrt(Phi g cos zeta)/d [m^-1/2 s^-1]
  double gradient_;  ///< mu_w/W [1/m]
};

/// zeta [rad] at which the flux is Q [kg/s] > 0. None where no slope carries it: reasons as `at`, or Q above the
/// largest flux.
[[nodiscard]] Answer<double> slope_of_flux(const Channel& channel, double Q, double thickness = unbounded);

/// sup of Q [kg/s] over all slopes of a heap of classical grains, reached as tan zeta -> mu_d (closed form). None for
/// other laws and without wall friction: their flux has no bound.
[[nodiscard]] std::optional<double> maximal_flux(const Channel& channel);

}  // namespace talus::steady
