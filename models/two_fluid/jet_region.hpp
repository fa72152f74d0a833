#pragma once

#include <cmath>

#include "core/scalar.hpp"
#include "two_fluid/parameters.hpp"

namespace talus::two_fluid {

/// Width of the inlet along the base [m]: a slot with the standard deviation that the scene states.
inline double inlet_width(const Inflow& inflow) { return std::sqrt(12.0) * inflow.width; }

/// 0 below 0, 1 above 1, with a continuous derivative.
template <class S>
S smooth_step(const S& x) {
  return core::select_above(
      x, 0.0,
      [&] {
        return core::select_above(
            x, 1.0, [] { return S(1.0); }, [&] { return S(x * x * (3.0 - 2.0 * x)); });
      },
      [] { return S(0.0); });
}

/// How much a cell counts as one of the heap [1]: inside a heap phi is above, in the jet below these; what lies between counts in part.
template <class S>
S densely_filled(const S& phi) {
  constexpr double jet_phi = 0.3, heap_phi = 0.7;
  return smooth_step(S((phi - jet_phi) / (heap_phi - jet_phi)));
}

/// The jet's corridor in gravity-aligned coordinates (X horizontal, Z upright), and Omega of (5.11). Z counts from where the jet's
/// middle would meet the base.
class JetRegion {
 public:
  /// No region where nothing is poured.
  JetRegion() = default;
  explicit JetRegion(const Parameters& par)
      : exists_(par.inflow.rate > 0.0),
        resolved_(par.numerics.jet == Jet::resolved),
        sine_(std::sin(par.inflow.along_gravity ? par.box.tilt : 0.0)),
        cosine_(std::cos(par.inflow.along_gravity ? par.box.tilt : 0.0)),
        half_slot_(0.5 * inlet_width(par.inflow) * cosine_),
        half_(half_slot_ + par.numerics.jet_margin),
        clearance_(par.numerics.jet_clearance) {
    X_jet_ = par.inflow.position * cosine_ + par.box.height * sine_;
    Z_foot_ = -X_jet_ * sine_ / cosine_;
  }

  [[nodiscard]] bool exists() const { return exists_; }
  /// Whether Omega may be less than 1 at (x, z): nowhere, where grains fall freely.
  [[nodiscard]] bool in_corridor(double x, double z) const { return exists_ && resolved_ && std::abs(X(x, z)) < half_; }
  /// Width of the corridor [m].
  [[nodiscard]] double width() const { return 2.0 * half_; }
  /// Whether a cell of sides dx, dz about (x, z) comes nearer to the corridor than `margin` [m].
  [[nodiscard]] bool comes_near(double x, double z, double dx, double dz, double margin) const {
    return exists_ && std::abs(X(x, z)) < half_ + margin + half_breadth(dx, dz);
  }
  /// Share of a cell of sides dx, dz about (x, z) that lies in the corridor [1]: exact but for the cell's corners.
  [[nodiscard]] double share_of_cell(double x, double z, double dx, double dz) const {
    const double reach = half_breadth(dx, dz);
    const double from = std::fmax(X(x, z) - reach, -half_), to = std::fmin(X(x, z) + reach, half_);
    return std::fmax(to - from, 0.0) / (2.0 * reach);
  }
  /// Height along gravity over the point where the jet's middle would meet the base [m].
  [[nodiscard]] double height(double x, double z) const { return z * cosine_ - x * sine_ - Z_foot_; }
  [[nodiscard]] double clearance() const { return clearance_; }
  /// Omega at (x, z) over a heap whose highest point is at `heap` [m]: 0 in the jet, 1 outside, H_b (5.12) being where it is one half.
  template <class S>
  S omega(double x, double z, const S& heap) const {
    if (!in_corridor(x, z)) return S(1.0);
    return S(1.0) - smooth_step(S((height(x, z) - heap - clearance_) / clearance_ + 0.5));
  }

 private:
  /// Of a cell, across the jet [m].
  [[nodiscard]] double half_breadth(double dx, double dz) const { return 0.5 * (dx * cosine_ + dz * std::abs(sine_)); }
  [[nodiscard]] double X(double x, double z) const { return x * cosine_ + z * sine_ - X_jet_; }

  bool exists_ = false, resolved_ = true;
  double sine_ = 0.0, cosine_ = 1.0, half_slot_ = 0.0, half_ = 0.0, clearance_ = 1.0, X_jet_ = 0.0, Z_foot_ = 0.0;
};

}  // namespace talus::two_fluid
