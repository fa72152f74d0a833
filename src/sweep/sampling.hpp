#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace talus::sweep {

/// Random numbers that are the same on every machine: the bits of std::mt19937_64, which the standard fixes, without the
/// standard's distributions, which it does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  /// A multiple of 2^-32 in [0, 1).
  double share();
  /// Uniform in 0..n-1, n >= 1, without the bias of a plain remainder.
  std::uint64_t below(std::uint64_t n);

 private:
  std::mt19937_64 bits_;
};

/// Points in the unit cube, `points[axis][i]` in [0, 1): independent and uniform.
std::vector<std::vector<double>> random_points(std::size_t n_axes, std::size_t n_points, std::uint64_t seed);

/// The same, but each of the n_points equal parts of each axis holds exactly one point (McKay, Beckman & Conover 1979).
std::vector<std::vector<double>> latin_hypercube(std::size_t n_axes, std::size_t n_points, std::uint64_t seed);

}  // namespace talus::sweep
