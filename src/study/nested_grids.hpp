#pragma once

#include <cstddef>
#include <span>

namespace talus::study {

/// Values of one field on a grid of layers and columns, row-major.
struct GridValues {
  std::size_t n_layers;
  std::size_t n_columns;
  std::span<const double> values;  ///< shape (n_layers, n_columns)
};

/// Of the differences of two fields: means over cells, and the largest.
struct DifferenceNorms {
  double L1, L2, Linf;
};

/// Compares a field on a grid with itself on a finer one that parts each of its cells into equal numbers of cells: the mean over
/// the fine cells of a cell stands against the coarse value, which is right to second order in the cells' size. Cells where either
/// has no value (NaN) are left out; all NaN where none remains. Throws std::invalid_argument where the grids are not nested.
[[nodiscard]] DifferenceNorms difference(const GridValues& coarse, const GridValues& fine);

}  // namespace talus::study
