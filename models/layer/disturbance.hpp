#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace talus::layer {

/// A small disturbance of the speed along the base of a periodic layer, one function of x and z that every grid samples:
///
///   sum over waves m and profiles n of  speed cos(2 pi m x/L + phase_mn) sin((n - 1/2) pi z/H),
///
/// each profile zero on the base and without shear on the surface. The phases hang on the seed, m and n alone, so that more waves or
/// profiles leave those that were there as they are.
struct Disturbance {
  double speed;               ///< amplitude of each wave and profile [m/s]
  int first_wave, last_wave;  ///< whole waves over the box, from 1
  int profiles;               ///< n = 1 to this
  std::uint64_t seed;
};

/// At `x` over L and `z` over H, shape (z, x) [m/s].
[[nodiscard]] std::vector<double> sampled(const Disturbance& disturbance, std::span<const double> x,
                                          std::span<const double> z);

/// Parts of a speed on a ring of columns, as root mean squares over layers and columns [m/s].
struct WaveParts {
  double disturbed;  ///< of waves first_wave to last_wave
  double others;     ///< of all other waves; the mean over x counts nowhere
};

/// `u` of each layer over equal columns, shape (layer, column).
[[nodiscard]] WaveParts wave_parts(const Disturbance& disturbance, std::span<const double> u, int n_columns);

}  // namespace talus::layer
