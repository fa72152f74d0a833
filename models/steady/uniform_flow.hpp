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
  /// Bagnold's flow (B2). None where the law has no friction tan zeta, where that does not exceed mu(0), and where speed
  /// or flux are beyond 1e-280 to 1e280. Throws std::invalid_argument on bad input.
  static Answer<UniformFlow> at(const Channel& channel, double zeta, double thickness = unbounded);
  /// As `at`, for the slope whose tangent is `mu`: exact where zeta would round, near 90 degrees and near the law's bounds.
  static Answer<UniformFlow> at_friction(const Channel& channel, double mu, double thickness = unbounded);
  /// The limit of the flow as tan zeta rises to mu_d, where the law saturates: its inertial number is unbounded at the
  /// surface, speed and flux are finite. None where the law does not saturate or no walls bound the shear.
  static std::optional<UniformFlow> steepest(const Channel& channel, double thickness = unbounded);

  [[nodiscard]] const rheology::Law& law() const { return channel_.law; }
  [[nodiscard]] double zeta() const { return zeta_; }
  [[nodiscard]] double tan_zeta() const { return tan_zeta_; }
  /// (4.9) [m]: below it nothing flows; -infinity without wall friction.
  [[nodiscard]] double z_st() const { return z_st_; }
  /// The flowing depth [m]: -z_st, or the thickness where that is less.
  [[nodiscard]] double depth() const { return depth_; }
  /// Whether the base bounds the flow, not wall friction.
  [[nodiscard]] bool on_base() const { return depth_ < -z_st_; }
  /// mu (4.8) in the flowing depth.
  [[nodiscard]] double friction(double z) const;
  /// I (4.11); zero below z_st.
  [[nodiscard]] double inertial_number(double z) const;
  /// Depth [m], from 0 to `depth()`, above which the inertial number exceeds `I`.
  [[nodiscard]] double depth_of_inertial_number(double I) const;
  /// u [m/s], the integral of (4.12). Relative error below 1e-10, also where u is many orders below the surface speed.
  [[nodiscard]] double speed(double z) const;
  /// The same at many heights, in one pass.
  [[nodiscard]] std::vector<double> speeds(std::span<const double> z) const;
  [[nodiscard]] double surface_speed() const { return speed(0.0); }
  /// Q (4.13) [kg/s].
  [[nodiscard]] double flux() const { return flux_above(depth_); }
  /// The part of Q [kg/s] that flows within `h` [m] of the surface.
  [[nodiscard]] double flux_above(double h) const;
  /// That over rho W [m2/s].
  [[nodiscard]] double volume_flux_above(double h) const;
  /// Depth [m], positive, at which the speed is `share` (0..1) of the surface speed.
  [[nodiscard]] double depth_at_share(double share) const;
  /// Mean speed [m/s] within `h` [m] of the surface.
  [[nodiscard]] double mean_speed(double h) const { return volume_flux_above(h) / h; }
  /// That over sqrt(g h cos zeta). The creeping tail makes `depth()` a poor h.
  [[nodiscard]] double froude(double h) const;

 private:
  UniformFlow(const Channel& channel, double zeta, double mu, double thickness);
  /// A depth as x = sqrt(depth) [m^1/2], and the friction there, `friction - less`: in two parts, see rheology::inverse.
  struct Edge {
    double x, friction, less;
  };

  static Answer<UniformFlow> with(const Channel& channel, double zeta, double mu, double thickness);
  /// Whether speed and flux, by their orders of magnitude, lie well within the range of doubles.
  [[nodiscard]] bool can_be_stated() const;
  [[nodiscard]] Edge edge(double depth) const;
  /// The integral of I 2 x^power dx between two edges with no bend of the law in between.
  [[nodiscard]] double piece(int power, const Edge& top, const Edge& bottom) const;
  /// The same between two depths [m].
  [[nodiscard]] double moment(int power, double from_depth, double to_depth) const;

  Channel channel_;
  double zeta_, tan_zeta_, z_st_, depth_;
  double rate_;      ///< sqrt(Phi g cos zeta)/d [m^-1/2 s^-1]
  double gradient_;  ///< mu_w/W [1/m]
};

}  // namespace talus::steady
