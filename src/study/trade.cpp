#include "study/trade.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace talus::study {

std::vector<std::size_t> pareto_front(std::span<const Priced> choices) {
  std::vector<std::size_t> order(choices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return std::isnan(choices[i].cost) || std::isnan(choices[i].error); });
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return choices[a].cost != choices[b].cost ? choices[a].cost < choices[b].cost : choices[a].error < choices[b].error;
  });
  double best = std::numeric_limits<double>::infinity();
  std::erase_if(order, [&](std::size_t i) {
    if (!(choices[i].error < best)) return true;
    best = choices[i].error;
    return false;
  });
  return order;
}

std::optional<std::size_t> cheapest_within(std::span<const Priced> choices, double error) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (std::isnan(choices[i].cost) || !(choices[i].error <= error)) continue;
    if (!best || choices[i].cost < choices[*best].cost) best = i;
  }
  return best;
}

std::optional<double> growth_exponent(std::span<const double> sizes, std::span<const double> costs) {
  const auto n = static_cast<double>(sizes.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double x = std::log(sizes[i]), y = std::log(costs[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  constexpr double rounding = 1e-12;
  if (sizes.size() < 2 || spread <= rounding * n * sxx) return std::nullopt;
  return (n * sxy - sx * sy) / spread;
}

}  // namespace talus::study
