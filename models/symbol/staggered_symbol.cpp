#include "symbol/staggered_symbol.hpp"

#include <cmath>

namespace talus::symbol {

double staggered_growth(const rheology::Response& r, CornerViscosity viscosity, double phase_x, double phase_z) {
  const double kx = 2.0 * std::sin(0.5 * phase_x), kz = 2.0 * std::sin(0.5 * phase_z);  // over h
  const double mean = std::cos(0.5 * phase_x) * std::cos(0.5 * phase_z);
  const double softening = (1.0 - r.nu) * (viscosity == CornerViscosity::averaged ? mean * mean : 1.0);
  // Of the stream function psi, u = i kz psi, w = -i kx psi, in units of eta/h^2: stresses without the pressure's share.
  const double stress_xx = -2.0 * kx * kz;
  const double shear = (kx * kx - kz * kz) * (1.0 - softening);
  const double square = kx * kx + kz * kz, q = r.q * mean;
  // Divergence of momentum: square p = (kx^2 - kz^2) stress_xx + 2 kx kz (shear + q p).
  const double p = ((kx * kx - kz * kz) * stress_xx + 2.0 * kx * kz * shear) / (square - 2.0 * kx * kz * q);
  // Its curl: rho d(square psi)/dt = 2 kx kz stress_xx - (kx^2 - kz^2) (shear + q p).
  return (2.0 * kx * kz * stress_xx - (kx * kx - kz * kz) * (shear + q * p)) / square;
}

}  // namespace talus::symbol
