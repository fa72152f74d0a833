#pragma once

#include <complex>
#include <vector>

namespace talus::modes {

using Complex = std::complex<double>;

/// A solution shape e^(rate t) of a system linearised about a steady state: dF/dy shape + rate dF/dy' shape = 0.
struct Mode {
  Complex rate;                ///< growth rate and angular frequency [1/s]
  std::vector<Complex> shape;  ///< of the unknowns, any size; of a plane wave: of one block
  double residual;             ///< what of that equation is left, over the sum of its terms' sizes (2-norms)
};

}  // namespace talus::modes
