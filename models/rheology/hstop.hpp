#pragma once

#include <array>
#include <span>

#include "rheology/classical.hpp"
#include "rheology/grains.hpp"

namespace talus::rheology {

/// Thickness h_stop that a flow leaves behind on a rough plane of slope zeta (appendix A):
/// tan zeta = mu_s + (mu_d - mu_s)/(h_stop/L + 1), (A2).
struct HstopCurve {
  double mu_s, mu_d;
  double length;  ///< L [m]

  /// tan zeta at a thickness h [m].
  [[nodiscard]] double tan_slope(double h) const { return mu_s + (mu_d - mu_s) / (h / length + 1.0); }
  /// h_stop [m] at zeta [rad]: infinite up to atan mu_s, zero from atan mu_d on.
  [[nodiscard]] double thickness(double zeta) const;
};

/// Checked: mu_s and mu_d as `classical` demands and unlike, L above 0. Throws std::invalid_argument.
[[nodiscard]] HstopCurve hstop_curve(double mu_s, double mu_d, double length);

/// The classical law of grains whose flows keep Fr = beta h/h_stop (A1): I_0 = 5 beta d/(2 sqrt(Phi) L), (A6). Throws
/// std::invalid_argument where beta is not above 0.
[[nodiscard]] Classical classical_of(const HstopCurve& curve, double beta, const Grains& grains);
/// The way back: L from I_0. The law needs mu_d above mu_s.
[[nodiscard]] HstopCurve hstop_of(const Classical& law, double beta, const Grains& grains);

/// A measurement.
struct HstopPoint {
  double zeta;       ///< [rad]
  double thickness;  ///< [m]
};

/// (A2) fitted to measurements by least squares of tan zeta: errors of the angle count, not those of the thickness.
struct HstopFit {
  HstopCurve curve;
  std::array<double, 3> error;  ///< standard errors of mu_s [1], mu_d [1], L [m], from the scatter of the residuals
  std::array<std::array<double, 3>, 3> correlation;  ///< of mu_s, mu_d, L
  double residual;                                   ///< rms of tan zeta - (A2), over the degrees of freedom
};

/// Throws std::invalid_argument, saying why, where the data cannot determine the three: fewer than four points, fewer
/// than three angles or thicknesses, angles outside (0, pi/2), thicknesses not above 0 or not falling with the angle,
/// parameters that only angles known to better than a ten thousandth would tell apart, or a standard error larger than
/// its parameter.
[[nodiscard]] HstopFit fit_hstop(std::span<const HstopPoint> points);

}  // namespace talus::rheology
