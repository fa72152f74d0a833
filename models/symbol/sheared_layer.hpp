#pragma once

#include <complex>
#include <vector>

#include "rheology/grains.hpp"
#include "rheology/law.hpp"

namespace talus::symbol {

/// The layer model's own operator about frozen uniform shear, as it acts on plane waves: its Fourier symbol, read from the exact Jacobian.
/// The layer is weightless, without convection (which frozen theory leaves out) and any regularisation; cells are square. Rows are
/// read in its middle, where stencils see neither base nor surface nor ends.
class ShearedLayer {
 public:
  using Complex = std::complex<double>;

  /// Uniform shear at inertial number I > 0 in cells h [m] wide and high. Throws std::invalid_argument for values that are not
  /// above 0, and what the layer model throws.
  ShearedLayer(const rheology::Grains& grains, const rheology::Law& law, double I, double h);

  /// [1/s]
  [[nodiscard]] double shear() const { return shear_; }
  /// Growth rate [1/s] of the one mode without divergence of a wave, by its phase advances from cell to cell, k_x h and k_z h [rad].
  /// NaN where that mode has no inertia on this grid, as at (pi, 0): it follows at once and neither grows nor decays.
  [[nodiscard]] Complex growth(double phase_x, double phase_z) const;

 private:
  /// One entry of the Jacobian, at its distance from its row in half cells.
  struct Entry {
    int row, field, x, z;
    double stiffness, mass;
  };
  double shear_;
  double mass_ = 0.0;  ///< largest entry of dF/dy'
  std::vector<Entry> entries_;
};

}  // namespace talus::symbol
