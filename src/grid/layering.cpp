#include "grid/layering.hpp"

#include <cmath>

namespace talus::grid {
namespace {

/// By how much a column has grown from its surface to the share 1/n of its layers: (1 + H/H0)^(1/n) - 1.
double growth(double H, double H0, int n) { return std::expm1(std::log1p(H / H0) / n); }

}  // namespace

void Layering::heights(double H, std::span<double> z, std::span<double> dz, std::span<double> d2z) const {
  if (spacing_ == Spacing::uniform) {
    for (int k = 0; k <= n_; ++k) {
      dz[k] = static_cast<double>(k) / n_;
      z[k] = dz[k] * H;
      d2z[k] = 0.0;
    }
    return;
  }
  const double each = growth(H, H0_, n_), inverse = 1.0 / (H0_ + H);
  double grown = 0.0;  // (1 + H/H0)^s - 1 at the share s of the layers above; each layer adds to it, so nothing cancels
  for (int k = n_; k > 0; --k) {
    const double s = 1.0 - static_cast<double>(k) / n_;
    const double slope = s * (grown + 1.0) * H0_ * inverse;  // of the depth
    z[k] = H - H0_ * grown;
    dz[k] = 1.0 - slope;
    d2z[k] = slope * (1.0 - s) * inverse;
    grown += each * (1.0 + grown);
  }
  z[0] = dz[0] = d2z[0] = 0.0;
}

double Layering::top_layer(double H) const { return spacing_ == Spacing::uniform ? H / n_ : H0_ * growth(H, H0_, n_); }

}  // namespace talus::grid
