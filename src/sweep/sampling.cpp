#include "sweep/sampling.hpp"

#include <numeric>
#include <utility>

namespace talus::sweep {

double Random::share() { return static_cast<double>(bits_() >> 32U) * 0x1p-32; }

std::uint64_t Random::below(std::uint64_t n) {
  const std::uint64_t incomplete = (0 - n) % n;  // 2^64 modulo n: so many of the smallest values would favour some
  for (;;) {
    const std::uint64_t value = bits_();
    if (value >= incomplete) return value % n;
  }
}

std::vector<std::vector<double>> random_points(std::size_t n_axes, std::size_t n_points, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<double>> points(n_axes, std::vector<double>(n_points));
  for (auto& axis : points) {
    for (auto& share : axis) share = random.share();
  }
  return points;
}

std::vector<std::vector<double>> latin_hypercube(std::size_t n_axes, std::size_t n_points, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<double>> points(n_axes, std::vector<double>(n_points));
  std::vector<std::size_t> part(n_points);
  for (auto& axis : points) {
    std::iota(part.begin(), part.end(), 0);
    for (std::size_t i = n_points; i > 1; --i) std::swap(part[i - 1], part[random.below(i)]);
    for (std::size_t i = 0; i < n_points; ++i) {
      axis[i] = (static_cast<double>(part[i]) + random.share()) / static_cast<double>(n_points);
    }
  }
  return points;
}

}  // namespace talus::sweep
