#pragma once

#include <functional>
#include <span>
#include <vector>

namespace talus::symbol {

/// The fastest of all the waves of a grid.
struct FastestWave {
  double growth;            ///< as `growth` gives it
  double phase_x, phase_z;  ///< k_x h and k_z h [rad]
};

/// Of each grid of N cells a side the fastest wave that fits it: phases 2 pi (m, n)/N, m from 1 to N/2, n from -N/2 + 1 to N/2. Waves along
/// z alone (m = 0) cannot grow by a law of mu(I) with mu' >= 0 and are left out.
/// `growth(phase_x, phase_z)`: by any measure that does not depend on N; NaN for a wave without a rate, which is passed over. `sizes`: powers of 2, ascending: then the waves of one grid
/// are waves of the next, and each is looked at once. Throws std::invalid_argument for other sizes.
[[nodiscard]] std::vector<FastestWave> fastest_waves(const std::function<double(double, double)>& growth,
                                                     std::span<const int> sizes);

}  // namespace talus::symbol
