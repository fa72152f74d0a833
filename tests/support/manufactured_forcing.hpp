#pragma once

#include <vector>

#include "grid/layering.hpp"
#include "layer/layer.hpp"
#include "support/layer_flow.hpp"
#include "support/manufactured_flow.hpp"

namespace talus::tests {

/// Drives the layer model with the sources and boundary data of a manufactured flow, on the grid that the flow's own surface
/// makes.
class ManufacturedForcing : public layer::Forcing {
 public:
  using Surface = std::function<Taylor2(const Taylor2& x, const Taylor2& t)>;

  ManufacturedForcing(const layer::Parameters& par, Flow flow, Medium medium, Surface surface)
      : columns_{par.grid.columns, par.grid.layers, par.box.length, par.box.periodic},
        slip_length_(par.box.base_slip_length),
        layering_(par.grid.layers, par.grid.cluster_depth, par.grid.spacing),
        flow_(std::move(flow)),
        medium_(std::move(medium)),
        surface_(std::move(surface)) {}

  [[nodiscard]] double height(double x, double t) const { return surface_at(x, t).value; }
  [[nodiscard]] PointFlow exact(double x, double z, double t) const {
    const auto f = flow_at(flow_, x, z, t);
    return {f.u.value, f.w.value, f.p.value};
  }

  [[nodiscard]] layer::Vector force(int f, int k, double t) const override {
    const double x = columns_.x_face(f);
    return balance_of(flow_at(flow_, x, middle(height(x, t), k), t), medium_).force;
  }
  /// By so much slower than the flow as its grains slip.
  [[nodiscard]] double base_speed(int f, double t) const override {
    const auto u = flow_at(flow_, columns_.x_face(f), 0.0, t).u;
    return u.value - slip_length_ * u.first[Taylor2::z];
  }
  [[nodiscard]] double lid_speed(int f, double t) const override {
    const double x = columns_.x_face(f);
    return exact(x, height(x, t), t).u;
  }
  [[nodiscard]] double lid_pressure(double t) const override {
    const double x = columns_.x_centre(columns_.n_columns - 1), H = height(x, t), z = middle(H, columns_.n_layers - 1);
    return exact(x, z, t).p + medium_.weight.z * (H - z);
  }
  [[nodiscard]] double surface_pressure(int i, double t) const override {
    const auto [s, T] = traction(columns_.x_centre(i), t);
    return (s * T.x - T.z) / (1.0 + s * s);
  }
  [[nodiscard]] layer::Vector surface_pull(int f, double t) const override {
    const auto [s, T] = traction(columns_.x_face(f), t);
    const double along = (T.x + s * T.z) / (1.0 + s * s);
    return {along, s * along};
  }

 private:
  [[nodiscard]] Taylor2 surface_at(double x, double t) const {
    return surface_(Taylor2::variable(x, Taylor2::x), Taylor2::variable(t, Taylor2::t));
  }
  [[nodiscard]] double middle(double H, int k) const {
    std::vector<double> z(columns_.n_layers + 1), dz(z), d2z(z);
    layering_.heights(H, z, dz, d2z);
    return 0.5 * (z[k] + z[k + 1]);
  }
  /// Slope of the surface, and the whole stress on it per unit length of x.
  [[nodiscard]] std::pair<double, layer::Vector> traction(double x, double t) const {
    const auto H = surface_at(x, t);
    const auto f = flow_at(flow_, x, H.value, t);
    const auto b = balance_of(f, medium_);
    const double s = H.first[Taylor2::x], p = f.p.value;
    return {s, {p * s + b.tau_xz - s * b.tau_xx, -p - b.tau_xx - s * b.tau_xz}};
  }

  grid::Columns columns_;
  double slip_length_;
  grid::Layering layering_;
  Flow flow_;
  Medium medium_;
  Surface surface_;
};

}  // namespace talus::tests
