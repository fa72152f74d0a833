#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "core/scalar.hpp"
#include "fv/term.hpp"
#include "grid/columns.hpp"
#include "grid/layering.hpp"
#include "layer/parameters.hpp"

namespace talus::layer {

/// What all kernels of the layer model share for one state: parameters, time, and all that depends on the thicknesses alone.
struct Context {
  const Parameters* parameters = nullptr;
  grid::Columns columns{};
  double t = 0.0;
  double weight_along = 0.0, weight_down = 0.0;  ///< rho g along x and against z [Pa/m]
  /// Heights of all interfaces [m] and their derivatives by the column's thickness, shape (n_columns, n_layers + 1) each.
  std::vector<double> z, dz, d2z;
  /// dz/dx of the interfaces across two columns, and in a last column beyond the ends, where the nearest column stands in.
  std::vector<double> slope;
  std::vector<core::Dual<1>> mobility;    ///< of each column, by its thickness; see film.hpp
  std::vector<core::Dual<2>> film_share;  ///< 1 - heap_share of each face, by the thicknesses left and right of it

  [[nodiscard]] std::size_t at(int i, int k) const {
    return static_cast<std::size_t>(columns.column(i)) * (columns.n_layers + 1) + k;
  }
  [[nodiscard]] std::size_t slope_at(int i, int k) const {
    return columns.has_column(i) ? at(i, k) : static_cast<std::size_t>(columns.n_columns) * (columns.n_layers + 1) + k;
  }
};

namespace detail {

/// Scalar in which geometry is computed: a dual over the few thicknesses alone, widened to the kernel's inputs at the end.
inline constexpr int most_columns = 5;
template <class S>
struct Geometric {
  using type = S;
  static const S& narrow(const S& x, int /*slot*/) { return x; }
  static const S& widen(const S& x, int /*slot*/) { return x; }
};
template <int N>
struct Geometric<core::Dual<N>> {
  using type = core::Dual<most_columns>;
  static type narrow(const core::Dual<N>& x, int slot) {
    type r(x.value);
    for (int c = 0; c < most_columns && slot + c < N; ++c) r.slope[c] = x.slope[slot + c];
    return r;
  }
  static core::Dual<N> widen(const type& x, int slot) {
    core::Dual<N> r(x.value);
    for (int c = 0; c < most_columns && slot + c < N; ++c) r.slope[slot + c] = x.slope[c];
    return r;
  }
};

}  // namespace detail

/// Heights and slopes of the grid as a kernel sees them, over neighbouring columns numbered 0, 1, ... from `first` on, whose
/// thicknesses are the kernel's last inputs, from `slot` on. "Face c" is the face on the left of column c. Every quantity
/// carries its dependence on the thicknesses and their rates. A Pack is of layers one above the other, from the one that is named.
template <class S, int N>
class Heights {
  using Geometric = detail::Geometric<S>;
  using G = typename Geometric::type;

 public:
  Heights(const Context& context, int first, const fv::Inputs<S, N>& in, int slot)
      : c_(context), first_(first), slot_(slot), dx_(context.columns.dx()) {
    static_assert(N >= 1);
    for (int c = 0; slot + c < N; ++c) {
      start_[c] = context.at(first + c, 0);
      if constexpr (core::is_plain<G>) slope_start_[c] = context.slope_at(first + c, 0);
      H_[c] = Geometric::narrow(in.y[slot + c], slot);
      rate_[c] = Geometric::narrow(in.rate[slot + c], slot);
    }
  }

  [[nodiscard]] S H(int c) const { return wide(H_[c]); }
  /// The share of column c that may flow, and how much of the flux through face c is that of a film.
  [[nodiscard]] S mobility(int c) const {
    const auto& m = c_.mobility[c_.columns.column(first_ + c)];
    return wide(core::lift(m.value, m.slope[0], H_[c]));
  }
  [[nodiscard]] S film_share(int c) const {
    const auto& share = c_.film_share[c_.columns.face(first_ + c)];
    G r = core::lift(share.value, share.slope[0], H_[c - 1]);
    r += core::lift(0.0, share.slope[1], H_[c]);
    return wide(r);
  }
  /// Height of interface k above the base [m].
  [[nodiscard]] S z(int c, int k) const { return wide(z_at(c, k)); }
  /// Velocity of interface k of face c [m/s].
  [[nodiscard]] S z_face_rate(int c, int k) const { return wide(0.5 * (rate_at(c - 1, k) + rate_at(c, k))); }
  /// Thickness of layer k in a column and at a face [m].
  [[nodiscard]] S h(int c, int k) const { return wide(z_at(c, k + 1) - z_at(c, k)); }
  [[nodiscard]] S h_face(int c, int k) const {
    return wide(0.5 * (z_at(c - 1, k + 1) - z_at(c - 1, k) + z_at(c, k + 1) - z_at(c, k)));
  }
  /// Slope of the middle of layer k between the columns beside face c, as these two alone see it [1].
  [[nodiscard]] S rise(int c, int k) const {
    return wide((z_at(c, k) + z_at(c, k + 1) - z_at(c - 1, k) - z_at(c - 1, k + 1)) * (0.5 / dx_) + base_slope());
  }
  /// dz/dx of interface k at column c, across its two faces [1]. A uniform velocity (u, w) is omega = w - u slope: the same
  /// slopes, averaged, turn omega back into w, so that a uniform flow stays uniform on any grid, moving or not.
  [[nodiscard]] S slope(int c, int k) const { return wide(slope_at(c, k)); }
  /// Slope at interface k of face c, and at the middle of layer k of face c and of column c.
  [[nodiscard]] S slope_corner(int c, int k) const { return wide(0.5 * (slope_at(c - 1, k) + slope_at(c, k))); }
  [[nodiscard]] S slope_face(int c, int k) const {
    return wide(0.25 * (slope_at(c - 1, k) + slope_at(c, k) + slope_at(c - 1, k + 1) + slope_at(c, k + 1)));
  }
  [[nodiscard]] S slope_centre(int c, int k) const { return wide(0.5 * (slope_at(c, k) + slope_at(c, k + 1))); }
  [[nodiscard]] S slope_face_rate(int c, int k) const {
    return wide(
        0.25 * (slope_rate_at(c - 1, k) + slope_rate_at(c, k) + slope_rate_at(c - 1, k + 1) + slope_rate_at(c, k + 1)));
  }

 private:
  [[nodiscard]] S wide(const G& x) const { return Geometric::widen(x, slot_); }
  [[nodiscard]] double base_slope() const { return c_.parameters->box.base_slope; }
  [[nodiscard]] G z_at(int c, int k) const {
    const auto a = start_[c] + k;
    if constexpr (std::is_same_v<G, core::Pack>) return core::Pack::at(&c_.z[a]);
    else return core::lift(c_.z[a], c_.dz[a], H_[c]);
  }
  [[nodiscard]] G rate_at(int c, int k) const {
    const auto a = start_[c] + k;
    if constexpr (std::is_same_v<G, core::Pack>) return core::Pack::at(&c_.dz[a]) * rate_[c];
    else return core::lift(c_.dz[a], c_.d2z[a], H_[c]) * rate_[c];
  }
  [[nodiscard]] G slope_at(int c, int k) const {
    if constexpr (std::is_same_v<G, core::Pack>) return core::Pack::at(&c_.slope[slope_start_[c] + k]);
    else if constexpr (core::is_plain<G>) return c_.slope[slope_start_[c] + k];
    else return (z_at(c + 1, k) - z_at(c - 1, k)) * (0.5 / dx_) + base_slope();
  }
  [[nodiscard]] G slope_rate_at(int c, int k) const { return (rate_at(c + 1, k) - rate_at(c - 1, k)) * (0.5 / dx_); }

  const Context& c_;
  int first_, slot_;
  double dx_;
  std::array<std::size_t, detail::most_columns> start_, slope_start_;  // of each column in the context's arrays
  std::array<G, detail::most_columns> H_, rate_;
};

}  // namespace talus::layer
