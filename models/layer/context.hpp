#pragma once

#include <vector>

#include "core/scalar.hpp"
#include "grid/columns.hpp"
#include "grid/layering.hpp"
#include "layer/parameters.hpp"

namespace talus::layer {

/// What all kernels of the layer model share for one state: parameters, time, and the heights of all interfaces with
/// their derivatives by the column's thickness, shape (n_columns, n_layers + 1) each.
struct Context {
  const Parameters* parameters = nullptr;
  grid::Columns columns{};
  double t = 0.0;
  std::vector<double> z, dz, d2z;

  [[nodiscard]] std::size_t at(int i, int k) const {
    return static_cast<std::size_t>(columns.column(i)) * (columns.n_layers + 1) + k;
  }
};

/// Heights and slopes of the grid as a kernel sees them, over M neighbouring columns numbered 0..M-1 from `first` on.
/// "face c" is the face on the left of column c. Every quantity carries its dependence on the thicknesses `H` of the
/// kernel's inputs; `rate` are their time derivatives.
template <class S>
class Heights {
 public:
  Heights(const Context& context, int first, const S* H, const S* rate)
      : c_(context), first_(first), H_(H), rate_(rate), dx_(context.columns.dx()) {}

  [[nodiscard]] const S& H(int c) const { return H_[c]; }
  /// Height of interface k above the base [m].
  [[nodiscard]] S z(int c, int k) const {
    const auto a = c_.at(first_ + c, k);
    return core::lift(c_.z[a], c_.dz[a], H_[c]);
  }
  /// Velocity of interface k [m/s].
  [[nodiscard]] S z_rate(int c, int k) const {
    const auto a = c_.at(first_ + c, k);
    return core::lift(c_.dz[a], c_.d2z[a], H_[c]) * rate_[c];
  }
  /// Thickness of layer k in a column and at a face [m].
  [[nodiscard]] S h(int c, int k) const { return z(c, k + 1) - z(c, k); }
  [[nodiscard]] S h_face(int c, int k) const { return 0.5 * (h(c - 1, k) + h(c, k)); }
  /// dz/dx of interface k at column c, across its two faces [1]. A uniform velocity (u, w) is omega = w - u slope: the same
  /// slopes, averaged, turn omega back into w, so that a uniform flow stays uniform on any grid, moving or not.
  [[nodiscard]] S slope(int c, int k) const {
    return (z(c + 1, k) - z(c - 1, k)) * (0.5 / dx_) + c_.parameters->box.base_slope;
  }
  [[nodiscard]] S slope_rate(int c, int k) const { return (z_rate(c + 1, k) - z_rate(c - 1, k)) * (0.5 / dx_); }
  /// Slope at interface k of face c, and at the middle of layer k of face c and of column c.
  [[nodiscard]] S slope_corner(int c, int k) const { return 0.5 * (slope(c - 1, k) + slope(c, k)); }
  [[nodiscard]] S slope_face(int c, int k) const { return 0.5 * (slope_corner(c, k) + slope_corner(c, k + 1)); }
  [[nodiscard]] S slope_centre(int c, int k) const { return 0.5 * (slope(c, k) + slope(c, k + 1)); }
  [[nodiscard]] S slope_face_rate(int c, int k) const {
    return 0.25 * (slope_rate(c - 1, k) + slope_rate(c, k) + slope_rate(c - 1, k + 1) + slope_rate(c, k + 1));
  }

 private:
  const Context& c_;
  int first_;
  const S* H_;
  const S* rate_;
  double dx_;
};

}  // namespace talus::layer
