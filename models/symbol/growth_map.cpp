#include "symbol/growth_map.hpp"

#include <bit>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace talus::symbol {

std::vector<FastestWave> fastest_waves(const std::function<double(double, double)>& growth,
                                       std::span<const int> sizes) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] < 2 || !std::has_single_bit(static_cast<unsigned>(sizes[i])) || (i > 0 && sizes[i] <= sizes[i - 1]))
      throw std::invalid_argument("fastest_waves: expected powers of 2, at least 2 and ascending");
  }
  constexpr double lowest = -std::numeric_limits<double>::infinity();
  std::vector<FastestWave> fastest(sizes.size(), {lowest, 0.0, 0.0});
  if (sizes.empty()) return fastest;
  const int finest = sizes.back();
  for (int m = 1; m <= finest / 2; ++m) {
    for (int n = -finest / 2 + 1; n <= finest / 2; ++n) {
      const double x = 2.0 * std::numbers::pi * m / finest, z = 2.0 * std::numbers::pi * n / finest;
      const double rate = growth(x, z);
      for (std::size_t i = sizes.size(); i-- > 0;) {
        const int step = finest / sizes[i];
        if (m % step != 0 || n % step != 0) break;  // nor is it one of a coarser grid
        if (rate > fastest[i].growth) fastest[i] = {rate, x, z};
      }
    }
  }
  return fastest;
}

}  // namespace talus::symbol
