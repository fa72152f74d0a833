#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace talus::grid {

using Index = std::int64_t;

/// Ascending nodes from 0 to `length` [m], shape n + 1: cells in geometric progression, the last `ratio` times as long as the first.
inline std::vector<double> geometric_nodes(int n, double length, double ratio) {
  std::vector<double> nodes(n + 1, 0.0);
  const double growth = n > 1 ? std::pow(ratio, 1.0 / (n - 1)) : 1.0;
  double cell = 1.0;
  for (int i = 0; i < n; ++i, cell *= growth) nodes[i + 1] = nodes[i] + cell;
  const double all = nodes[n];
  for (int i = 0; i <= n; ++i) nodes[i] *= length / all;
  return nodes;
}

/// A fixed grid of upright rectangles, of any spacing in each direction. Cell (i, k) lies between faces i and i + 1 and between
/// interfaces k and k + 1.
class Rectilinear {
 public:
  /// `x_nodes`, `z_nodes`: ascending. Steps that differ by rounding alone are the same to the last bit.
  Rectilinear(std::vector<double> x, std::vector<double> z, bool is_periodic)
      : x_nodes(std::move(x)),
        z_nodes(std::move(z)),
        periodic(is_periodic),
        x_steps_(steps(x_nodes)),
        z_steps_(steps(z_nodes)) {}

  std::vector<double> x_nodes;  ///< faces [m], shape n_columns + 1
  std::vector<double> z_nodes;  ///< interfaces [m], shape n_layers + 1
  bool periodic;                ///< the last face is the first

  [[nodiscard]] int n_columns() const { return static_cast<int>(x_nodes.size()) - 1; }
  [[nodiscard]] int n_layers() const { return static_cast<int>(z_nodes.size()) - 1; }
  /// Distinct faces.
  [[nodiscard]] int n_faces() const { return periodic ? n_columns() : n_columns() + 1; }
  [[nodiscard]] bool has_column(int i) const { return periodic || (i >= 0 && i < n_columns()); }
  [[nodiscard]] bool has_layer(int k) const { return k >= 0 && k < n_layers(); }
  [[nodiscard]] bool has_face(int f) const { return periodic || (f >= 0 && f <= n_columns()); }
  /// The column `i`, wrapped in a periodic box, else the nearest one that exists.
  [[nodiscard]] int column(int i) const {
    const int n = n_columns();
    if (periodic) return (i % n + n) % n;
    return i < 0 ? 0 : (i >= n ? n - 1 : i);
  }
  [[nodiscard]] int face(int f) const { return periodic ? column(f) : f; }
  /// A face beyond which there is nothing.
  [[nodiscard]] bool is_end(int f) const { return !periodic && (f == 0 || f == n_columns()); }

  /// Width of the column nearest to `i`, height of the layer nearest to `k` [m].
  [[nodiscard]] double dx(int i) const { return x_steps_[column(i)]; }
  [[nodiscard]] double dz(int k) const { return z_steps_[k < 0 ? 0 : (k >= n_layers() ? n_layers() - 1 : k)]; }
  [[nodiscard]] double x_centre(int i) const { return 0.5 * (x_nodes[i] + x_nodes[i + 1]); }
  [[nodiscard]] double z_centre(int k) const { return 0.5 * (z_nodes[k] + z_nodes[k + 1]); }
  /// Between the middles of the columns beside face f, of the layers beside interface k [m]; beyond an end lies the mirror image.
  [[nodiscard]] double across_face(int f) const { return 0.5 * (dx(f - 1) + dx(f)); }
  [[nodiscard]] double across_interface(int k) const { return 0.5 * (dz(k - 1) + dz(k)); }
  /// Width about face f, height about interface k, of the volumes that end in the middle of cells [m].
  [[nodiscard]] double width_about(int f) const {
    return 0.5 * ((has_column(f - 1) ? dx(f - 1) : 0.0) + (has_column(f) ? dx(f) : 0.0));
  }
  [[nodiscard]] double height_about(int k) const {
    return 0.5 * ((has_layer(k - 1) ? dz(k - 1) : 0.0) + (has_layer(k) ? dz(k) : 0.0));
  }

 private:
  static std::vector<double> steps(const std::vector<double>& nodes) {
    constexpr double rounding = 1e-12;
    std::vector<double> all;
    const double mean = (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
    for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
      const double step = nodes[n + 1] - nodes[n];
      all.push_back(std::abs(step - mean) < rounding * mean ? mean : step);
    }
    return all;
  }

  std::vector<double> x_steps_, z_steps_;  // [m]
};

}  // namespace talus::grid
