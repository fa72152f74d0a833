#include "grid/layering.hpp"

#include <cmath>

namespace talus::grid {
namespace {

/// Depth below the surface with its first and second derivative by H.
struct Depth {
  double D, dD, d2D;
};

Depth clustered(double s, double H, double H0) {
  const double grown = std::expm1(s * std::log1p(H / H0)), inverse = 1.0 / (H0 + H);
  const double slope = s * (grown + 1.0) * H0 * inverse;
  return {H0 * grown, slope, slope * (s - 1.0) * inverse};
}

Depth depth(Spacing spacing, double s, double H, double H0) {
  return spacing == Spacing::uniform ? Depth{s * H, s, 0.0} : clustered(s, H, H0);
}

}  // namespace

void Layering::heights(double H, std::span<double> z, std::span<double> dz, std::span<double> d2z) const {
  for (int k = 0; k <= n_; ++k) {
    const auto below = depth(spacing_, 1.0 - static_cast<double>(k) / n_, H, H0_);
    z[k] = H - below.D;
    dz[k] = 1.0 - below.dD;
    d2z[k] = -below.d2D;
  }
  z[0] = dz[0] = d2z[0] = 0.0;
}

double Layering::top_layer(double H) const { return depth(spacing_, 1.0 / n_, H, H0_).D; }

}  // namespace talus::grid
