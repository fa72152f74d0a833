#pragma once

#include <cstdint>

namespace talus::grid {

using Index = std::int64_t;

/// Columns of layers under a height function: topology and uniform spacing along x. Column i lies between faces i and i + 1;
/// layer k lies between interfaces k and k + 1, from the base up.
struct Columns {
  int n_columns;
  int n_layers;
  double length;  ///< [m]
  bool periodic;

  [[nodiscard]] double dx() const { return length / n_columns; }
  /// Distinct faces: one more than the columns, unless the last is the first.
  [[nodiscard]] int n_faces() const { return periodic ? n_columns : n_columns + 1; }
  /// The column `i`, wrapped in a periodic box, else the nearest one that exists.
  [[nodiscard]] int column(int i) const {
    if (periodic) return (i % n_columns + n_columns) % n_columns;
    return i < 0 ? 0 : (i >= n_columns ? n_columns - 1 : i);
  }
  [[nodiscard]] bool has_column(int i) const { return periodic || (i >= 0 && i < n_columns); }
  [[nodiscard]] int face(int f) const { return periodic ? (f % n_columns + n_columns) % n_columns : f; }
  [[nodiscard]] bool has_face(int f) const { return periodic || (f >= 0 && f <= n_columns); }
  /// A face at an open or walled end.
  [[nodiscard]] bool is_end(int f) const { return !periodic && (f == 0 || f == n_columns); }
  [[nodiscard]] double x_centre(int i) const { return (i + 0.5) * dx(); }
  [[nodiscard]] double x_face(int f) const { return f * dx(); }
};

}  // namespace talus::grid
