#include <algorithm>
#include <cmath>

#include "layer/terms/stress.hpp"
#include "rheology/wall_friction.hpp"
#include "rheology/well_posedness.hpp"
#include "support/manufactured_grain_wave.hpp"
#include "support/manufactured_wave.hpp"

namespace {

using namespace talus;
using tests::flow_at, tests::Taylor2, tests::Wave;
using enum grid::Spacing;

void expect_kinematics(const Wave& wave) {
  for (const double x : {0.0, 0.13, 0.4, 0.77}) {
    for (const double t : {0.0, 0.3, 1.1}) {
      const auto H = wave.surface(Taylor2::variable(x, Taylor2::x), Taylor2::variable(t, Taylor2::t));
      for (const double sigma : {0.0, 0.2, 0.9, 1.0}) {
        const auto f = flow_at(wave.flow, x, sigma * H.value, t);
        EXPECT_NEAR(f.u.first[Taylor2::x] + f.w.first[Taylor2::z], 0.0, 1e-13);
        if (sigma == 0.0) {
          EXPECT_NEAR(f.u.value, 0.0, 1e-15);
          EXPECT_NEAR(f.w.value, 0.0, 1e-15);
        }
        if (sigma == 1.0) { EXPECT_NEAR(f.w.value, H.first[Taylor2::t] + f.u.value * H.first[Taylor2::x], 1e-13); }
      }
    }
  }
}

TEST(LayerManufacturedSurface, FlowHasNoDivergenceAndMovesWithItsSurface) { expect_kinematics(tests::fluid_wave()); }
TEST(LayerManufacturedSurface, OrderIsTwoOnUniformLayers) {
  tests::expect_wave_order("layer_manufactured_surface", tests::fluid_wave(),
                           {"uniform", uniform, {8, 16, 32}, 1.9, 1.65, 1.95});
}
TEST(LayerManufacturedSurface, OrderIsTwoOnStretchedLayers) {
  tests::expect_wave_order("layer_manufactured_surface", tests::fluid_wave(),
                           {"stretched", clustered, {8, 16, 32}, 1.9, 1.7, 1.5});
}

/// 2 D_norm [1/s].
double shear_rate(const tests::FlowAt& f) {
  using enum Taylor2::By;
  return std::hypot(2.0 * f.u.first[x], f.u.first[z] + f.w.first[x]);
}

TEST(LayerGrainSurface, FlowHasNoDivergenceAndMovesWithItsSurface) { expect_kinematics(tests::grain_wave(0.0)); }

TEST(LayerGrainSurface, InertialNumberIsWellPosedThroughout) {
  const auto wave = tests::grain_wave(0.0);
  const auto par = wave.parameters(8);
  double least = 1e9, most = 0.0;
  for (int i = 0; i < 60; ++i) {
    for (int n = 0; n < 20; ++n) {
      const double x = par.box.length * i / 60.0, t = wave.end * n / 19.0;
      const double H = wave.surface(x, t).value;
      EXPECT_NEAR(shear_rate(flow_at(wave.flow, x, H, t)), 0.0, 1e-6);
      for (const double sigma : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999}) {
        const auto f = flow_at(wave.flow, x, sigma * H, t);
        const double I = par.grains.d * shear_rate(f) / std::sqrt(f.p.value / par.grains.rho_star);
        const auto r = rheology::response(par.law, I);
        EXPECT_EQ(rheology::well_posedness(r), rheology::WellPosedness::well_posed);
        least = std::min(least, I), most = std::max(most, I);
      }
    }
  }
  EXPECT_GT(least, 0.2);
  EXPECT_LT(most, 0.4);
}

struct Stressed {
  double u, w, p, txx, txz;
};

/// The flow and, by central differences of its values and with the viscosity of the room, its stress.
Stressed stressed(const Wave& wave, const layer::Parameters& par, double x, double z, double t) {
  const double e = 1e-4;
  const auto here = flow_at(wave.flow, x, z, t);
  const auto right = flow_at(wave.flow, x + e, z, t), left = flow_at(wave.flow, x - e, z, t);
  const auto above = flow_at(wave.flow, x, z + e, t), below = flow_at(wave.flow, x, z - e, t);
  const auto tau =
      layer::stress(par, (right.u.value - left.u.value) / (2.0 * e),
                    (above.u.value - below.u.value + right.w.value - left.w.value) / (4.0 * e), here.p.value, 1.0);
  return {here.u.value, here.w.value, here.p.value, tau.xx, tau.xz};
}

layer::Vector force_by_differences(const Wave& wave, const layer::Parameters& par, double x, double z, double t) {
  const double e = 1e-3, rho = par.grains.rho(), g = rho * par.box.gravity;
  const auto here = stressed(wave, par, x, z, t);
  using Along = double Stressed::*;
  const auto by_x = [&](Along a) {
    return (stressed(wave, par, x + e, z, t).*a - stressed(wave, par, x - e, z, t).*a) / (2.0 * e);
  };
  const auto by_z = [&](Along a) {
    return (stressed(wave, par, x, z + e, t).*a - stressed(wave, par, x, z - e, t).*a) / (2.0 * e);
  };
  const auto inertia = [&](Along a) {
    const double by_t = (stressed(wave, par, x, z, t + e).*a - stressed(wave, par, x, z, t - e).*a) / (2.0 * e);
    return rho * (by_t + here.u * by_x(a) + here.w * by_z(a));
  };
  using S = Stressed;
  const double drag = 2.0 * par.wall.mu_w / par.box.gap * here.p *
                      rheology::friction_direction(here.u * here.u + here.w * here.w, par.wall.u_c);
  return {inertia(&S::u) + by_x(&S::p) - by_x(&S::txx) - by_z(&S::txz) - g * std::sin(par.box.tilt) + drag * here.u,
          inertia(&S::w) + by_z(&S::p) - by_x(&S::txz) + by_z(&S::txx) + g * std::cos(par.box.tilt) + drag * here.w};
}

TEST(LayerGrainSurface, SourcesAreThoseOfDifferences) {
  const auto wave = tests::grain_wave(0.3);
  const auto par = wave.parameters(8);
  for (const double x : {0.2, 1.1, 2.7}) {
    for (const double z : {0.1, 0.5, 0.8}) {
      const auto exact = tests::balance_of(flow_at(wave.flow, x, z, 0.2), wave.medium).force;
      const auto by_differences = force_by_differences(wave, par, x, z, 0.2);
      EXPECT_NEAR(exact.x, by_differences.x, 2e-5);
      EXPECT_NEAR(exact.z, by_differences.z, 2e-5);
    }
  }
}

TEST(LayerGrainSurface, OrderIsTwoOnUniformLayers) {
  tests::expect_wave_order("layer_grain_surface", tests::grain_wave(0.0),
                           {"uniform", uniform, {8, 16, 32}, 1.9, 1.85, 1.9});
}
TEST(LayerGrainSurface, OrderIsTwoBetweenWallsOnStretchedLayers) {
  tests::expect_wave_order("layer_grain_surface", tests::grain_wave(0.3),
                           {"stretched", clustered, {8, 16, 32}, 1.9, 1.85, 1.9});
}

}  // namespace
