#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace talus::grid {

/// How the depth D of an interface grows from the surface, s = 0, to the base, s = 1, in a column of thickness H:
/// - clustered: H0 ((1 + H/H0)^s - 1): uniform for H << H0, geometric for H >> H0;
/// - uniform: H s.
enum class Spacing : std::uint8_t { clustered, uniform };

/// Where the interfaces of the layers lie in a column of thickness H, smooth in H.
class Layering {
 public:
  /// n_layers >= 1, cluster_depth H0 > 0 [m]; uniform spacing does not read it.
  Layering(int n_layers, double cluster_depth, Spacing spacing = Spacing::clustered)
      : n_(n_layers), H0_(cluster_depth), spacing_(spacing) {}

  [[nodiscard]] int n_layers() const { return n_; }
  /// Heights z_k above the base [m] and their first and second derivatives with respect to H, shape n_layers + 1 each.
  void heights(double H, std::span<double> z, std::span<double> dz, std::span<double> d2z) const;
  /// Thickness of the top layer [m] in a column of thickness H [m].
  [[nodiscard]] double top_layer(double H) const;

 private:
  int n_;
  double H0_;
  Spacing spacing_;
};

}  // namespace talus::grid
