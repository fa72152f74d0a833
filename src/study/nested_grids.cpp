#include "study/nested_grids.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace talus::study {
namespace {

/// Mean over the fine cells of coarse cell (layer, column).
double mean_within(const GridValues& fine, std::size_t layer, std::size_t column, std::size_t up, std::size_t across) {
  double sum = 0.0;
  for (std::size_t k = layer * up; k < (layer + 1) * up; ++k) {
    for (std::size_t i = column * across; i < (column + 1) * across; ++i) sum += fine.values[k * fine.n_columns + i];
  }
  return sum / static_cast<double>(up * across);
}

void check(const GridValues& grid) {
  if (grid.n_layers == 0 || grid.n_columns == 0 || grid.values.size() != grid.n_layers * grid.n_columns)
    throw std::invalid_argument("difference: the values do not fill their grid");
}

}  // namespace

DifferenceNorms difference(const GridValues& coarse, const GridValues& fine) {
  check(coarse);
  check(fine);
  if (fine.n_layers % coarse.n_layers != 0 || fine.n_columns % coarse.n_columns != 0)
    throw std::invalid_argument("difference: the grids are not nested");
  const std::size_t up = fine.n_layers / coarse.n_layers, across = fine.n_columns / coarse.n_columns;
  double n = 0.0, sum = 0.0, squares = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < coarse.n_layers; ++k) {
    for (std::size_t i = 0; i < coarse.n_columns; ++i) {
      const double d = std::abs(mean_within(fine, k, i, up, across) - coarse.values[k * coarse.n_columns + i]);
      if (std::isnan(d)) continue;
      n += 1.0;
      sum += d;
      squares += d * d;
      largest = std::max(largest, d);
    }
  }
  if (n == 0.0) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  return {sum / n, std::sqrt(squares / n), largest};
}

}  // namespace talus::study
