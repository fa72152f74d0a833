#include "grid/layering.hpp"

#include <cmath>

namespace talus::grid {

void Layering::heights(double H, std::span<double> z, std::span<double> dz, std::span<double> d2z) const {
  const double log_ratio = std::log1p(H / H0_);
  const double inverse = 1.0 / (H0_ + H);
  for (int k = 0; k <= n_; ++k) {
    const double s = 1.0 - static_cast<double>(k) / n_;
    const double grown = std::expm1(s * log_ratio);
    const double slope = s * (grown + 1.0) * H0_ * inverse;
    z[k] = H - H0_ * grown;
    dz[k] = 1.0 - slope;
    d2z[k] = -slope * (s - 1.0) * inverse;
  }
  z[0] = dz[0] = d2z[0] = 0.0;
}

double Layering::top_layer(double H) const { return H0_ * std::expm1(std::log1p(H / H0_) / n_); }

}  // namespace talus::grid
