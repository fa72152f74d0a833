#pragma once

#include <vector>

#include "column/parameters.hpp"

namespace talus::column {

/// Where the layers lie: interface k below layer k, from the base, 0, to the surface, n_layers [m].
struct Heights {
  std::vector<double> interface;  ///< shape n_layers + 1
  std::vector<double> centre;     ///< shape n_layers: middles of the layers
  explicit Heights(const Parameters& parameters);

  [[nodiscard]] int n_layers() const { return static_cast<int>(centre.size()); }
  [[nodiscard]] double surface() const { return interface.back(); }
  [[nodiscard]] double thickness(int k) const { return interface[k + 1] - interface[k]; }
  /// Between the points at which speeds are known above and below interface k < n_layers: the base for k = 0.
  [[nodiscard]] double distance(int k) const { return centre[k] - (k > 0 ? centre[k - 1] : interface[0]); }
};

/// What all kernels share at one time.
struct Context {
  const Parameters* parameters;
  const Heights* heights;
  double weight;         ///< rho g sin zeta [Pa/m], down the slope
  double lithostatic;    ///< rho g cos zeta [Pa/m]
  double wall_friction;  ///< 2 mu_w/W [1/m]
  double rate_floor;     ///< under D_norm [1/s]

  /// p = rho g cos zeta (H - z) [Pa].
  [[nodiscard]] double pressure(double z) const { return lithostatic * (heights->surface() - z); }
};

}  // namespace talus::column
