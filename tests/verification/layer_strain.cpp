#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnostics/observed_order.hpp"
#include "layer/terms/stress.hpp"
#include "support/layer_cases.hpp"
#include "support/table.hpp"

/// The strain rates of the layer's stress terms, at corners and at centres, of velocities that are known everywhere.
namespace {

using namespace talus;

/// Velocity along x and along z at a point (x, z) of the box, z = 0 where the base meets x = 0 [m/s].
struct Flow {
  std::function<double(double, double)> u, w;
};

/// n columns by n layers of a thickness that grows along x by `surface` on a base of slope `base`, moving as `flow`.
struct Sampled {
  Sampled(int n, double surface, double base, const Flow& flow)
      : system(parameters(n, base)), y(system.layout().size()) {
    const auto& c = system.columns();
    const auto& at = system.unknowns();
    for (int i = 0; i < n; ++i) y[at.H(i)] = depth + surface * c.x_centre(i);
    const auto& context = system.context(0.0, y);
    const auto z = [&](int i, int k) { return context.z[context.at(i, k)]; };
    for (int i = 1; i < n - 1; ++i)
      for (int k = 0; k < n; ++k) {
        const double x = c.x_centre(i), above = z(i, k + 1) + base * x;
        const double slope = (z(i + 1, k + 1) - z(i - 1, k + 1)) / (2.0 * c.dx()) + base;
        y[at.omega(i, k + 1)] = flow.w(x, above) - flow.u(x, above) * slope;
        const double middle = 0.25 * (z(i - 1, k) + z(i - 1, k + 1) + z(i, k) + z(i, k + 1));
        y[at.u(i, k)] = flow.u(c.x_face(i), middle + base * c.x_face(i));
      }
  }

  static layer::Parameters parameters(int n, double base) {
    auto par = tests::periodic_layer(0.1, depth, 0.0, n, n);
    par.box.periodic = false;
    par.box.base_slope = base;
    par.grid.spacing = grid::Spacing::uniform;
    return par;
  }

  template <class Slots>
  [[nodiscard]] fv::Inputs<double, Slots::n_in> inputs(int across, int k) const {
    std::array<core::Index, Slots::n_in> from;
    Slots::connect(system.unknowns(), across, k, from);
    fv::Inputs<double, Slots::n_in> in{};
    for (int j = 0; j < Slots::n_in; ++j) in.y[j] = fv::read(y, from[j]);
    return in;
  }
  /// `base`: how grains meet it, for k = 0.
  [[nodiscard]] layer::CornerStrain<double> at_corner(int f, int k,
                                                      const std::optional<layer::Sticking>& base = {}) const {
    const auto in = inputs<layer::CornerSlots>(f, k);
    const layer::Heights<double, layer::CornerSlots::n_in> g(system.context(0.0, y), f - 2, in, layer::CornerSlots::H_);
    return layer::corner_strain(g, k, system.columns().dx(), base, in.y);
  }
  [[nodiscard]] layer::CornerStrain<double> at_centre(int i, int k) const {
    const auto in = inputs<layer::CentreSlots>(i, k);
    const layer::Heights<double, layer::CentreSlots::n_in> g(system.context(0.0, y), i - 2, in, layer::CentreSlots::H_);
    return layer::centre_strain(g, k, system.columns().n_layers, system.columns().dx(),
                                layer::bounds(system.context(0.0, y), i), in.y);
  }

  static constexpr double depth = 0.05;  // [m]
  layer::Layer system;
  std::vector<double> y;
};

/// Stretched, sheared and turned at once, on layers that lean against the columns and against one another.
TEST(LayerStrain, ConvergesToThatOfALinearVelocityOnLeaningLayers) {
  const double a = 0.3, stretch = 0.7, shear = 2.0, turn = -0.9;  // [m/s], [1/s]
  const Flow flow{[&](double x, double z) { return a + stretch * x + shear * z; },
                  [&](double x, double z) { return 0.5 * a + turn * x - stretch * z; }};
  const double D_xx = stretch, D_xz = 0.5 * (shear + turn);
  tests::Table table("layer_strain", {"surface", "base", "cells", "error at corners [1/s]", "error at centres [1/s]"});
  for (const auto& [surface, base] : {std::pair{0.6, 0.0}, {-0.3, 0.4}, {0.0, -0.5}}) {
    std::vector<double> h, corner, centre;
    for (const int n : {8, 16, 32}) {
      const Sampled grid(n, surface, base, flow);
      double at_corners = 0.0, at_centres = 0.0;
      const auto off = [&](const layer::CornerStrain<double>& D) {
        return std::max(std::abs(D.D_xx - D_xx), std::abs(D.D_xz - D_xz));
      };
      for (int i = 3; i < n - 3; ++i)
        for (int k = 1; k < n - 1; ++k) {
          at_corners = std::max(at_corners, off(grid.at_corner(i, k + 1)));  // the first feels the base's no-slip
          at_centres = std::max(at_centres, off(grid.at_centre(i, k)));
        }
      h.push_back(1.0 / n);
      corner.push_back(at_corners);
      centre.push_back(at_centres);
      table.row({surface, base, double(n), at_corners, at_centres});
    }
    for (const auto& error : {corner, centre}) {
      EXPECT_LT(error.back(), 2e-4) << surface << " " << base;
      if (error.front() > 1e-12) {
        EXPECT_GT(diagnostics::observed_orders(h, error).back(), 1.8) << surface << " " << base;
      }
    }
  }
}

/// A shear that varies along the base, on which grains slip by l times it: they stretch along it, at the rate of that.
TEST(LayerStrain, OfGrainsThatSlipOnTheBaseConvergesToItsOwn) {
  const double a = 2.0, c = 6.0, l = 0.02;  // [1/s], [1/s m], [m]
  const Flow flow{[&](double x, double z) { return (a + c * x) * (z + l); },
                  [&](double, double z) { return -c * z * (0.5 * z + l); }};
  tests::Table table("layer_strain_slip", {"surface", "cells", "error of D_xx [1/s]", "error of D_xz [1/s]"});
  for (const double surface : {0.0, 0.6, -0.3}) {
    std::vector<double> h, error;
    for (const int n : {8, 16, 32}) {
      const Sampled grid(n, surface, 0.0, flow);
      double along = 0.0, shear = 0.0;
      for (int f = 3; f < n - 3; ++f) {
        const auto D = grid.at_corner(f, 0, layer::Sticking{0.0, 0.0, l});
        along = std::max(along, std::abs(D.D_xx - c * l));
        shear = std::max(shear, std::abs(D.D_xz - 0.5 * (a + c * grid.system.columns().x_face(f))));
      }
      h.push_back(1.0 / n);
      error.push_back(along);
      EXPECT_LT(shear, 1e-12) << surface;
      table.row({surface, double(n), along, shear});
    }
    EXPECT_LT(error.back(), 1e-3 * c * l) << surface;
    if (error.front() > 1e-12) { EXPECT_GT(diagnostics::observed_orders(h, error).back(), 1.8) << surface; }
  }
}

/// Under a free surface shear grows as the root of the depth: also in the top layer, whose neighbours lie all below.
TEST(LayerStrain, IsThatOfBagnoldsProfileUpToTheTopLayer) {
  const int n = 16;
  const double H = Sampled::depth;
  const Sampled grid(
      n, 0.0, 0.0,
      {[&](double, double z) { return std::pow(H, 1.5) - std::pow(H - z, 1.5); }, [](double, double) { return 0.0; }});
  const auto shear = [&](double z) { return 1.5 * std::sqrt(H - z); };
  for (int k = 1; k < n; ++k) {
    EXPECT_NEAR(2.0 * grid.at_centre(8, k).D_xz / shear((k + 0.5) * H / n), 1.0, 0.025) << k;
    EXPECT_NEAR(2.0 * grid.at_corner(8, k).D_xz / shear(k * H / n), 1.0, 0.025) << k;
  }
}

}  // namespace
