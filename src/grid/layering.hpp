#pragma once

#include <span>
#include <vector>

namespace talus::grid {

/// Where the interfaces of the layers lie in a column of thickness H: clustered under the surface by depth
/// D(s) = H0 ((1 + H/H0)^s - 1), s = 1 - k/n: uniform for H << H0, geometric for H >> H0, smooth in H.
class Layering {
 public:
  /// n_layers >= 1, cluster_depth H0 > 0 [m].
  Layering(int n_layers, double cluster_depth) : n_(n_layers), H0_(cluster_depth) {}

  [[nodiscard]] int n_layers() const { return n_; }
  /// Heights z_k above the base [m] and their first and second derivatives with respect to H, shape n_layers + 1 each.
  void heights(double H, std::span<double> z, std::span<double> dz, std::span<double> d2z) const;
  /// Thickness of the top layer [m] in a column of thickness H [m].
  [[nodiscard]] double top_layer(double H) const;

 private:
  int n_;
  double H0_;
};

}  // namespace talus::grid
