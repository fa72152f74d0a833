#pragma once

namespace talus::rheology {

struct Grains {
  double rho_star;  ///< intrinsic density rho_* [kg/m3]
  double Phi;       ///< solids fraction within the grains [1]
  double d;         ///< diameter [m]
  [[nodiscard]] double rho() const { return Phi * rho_star; }
};

/// Throws std::invalid_argument naming the parameter that is not positive and finite, or a Phi above 1.
[[nodiscard]] Grains grains(double rho_star, double Phi, double d);

}  // namespace talus::rheology
