#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "layer/layer.hpp"
#include "support/example_scene.hpp"
#include "support/random_state.hpp"

/// Symmetries of the layer's equations that its operator keeps, at random states: mirror, turned gravity, total momentum.
namespace {

using namespace talus;
using tests::small;

struct State {
  std::vector<double> y, yp, r;
  State(const layer::Layer& system, unsigned seed) : r(system.layout().size()) {
    tests::RandomState{}.fill(system, seed, y, yp);
    system.residual(0.1, y, yp, r);
  }
};

std::vector<double> residual_of(const layer::Layer& system, const std::vector<double>& y,
                                const std::vector<double>& yp) {
  std::vector<double> r(y.size());
  system.residual(0.1, y, yp, r);
  return r;
}

/// The largest row of the field to which each row belongs: what its rounding is measured by.
std::vector<double> sizes(const core::Layout& layout, const std::vector<double>& r) {
  std::map<int, double> largest;
  for (core::Index i = 0; i < layout.size(); ++i)
    largest[layout.field_of[i]] = std::max(largest[layout.field_of[i]], std::abs(r[i]));
  std::vector<double> list(r.size());
  for (core::Index i = 0; i < layout.size(); ++i) list[i] = largest[layout.field_of[i]];
  return list;
}

class LayerSymmetry : public testing::TestWithParam<std::string> {};

std::vector<std::string> layer_examples() {
  std::vector<std::string> names;
  for (const auto& each : tests::every_case())
    if (each.model == "layer" && !small(each.scene, 9, 5).box.lid)
      names.push_back(each.scene);  // p is given at a lid's right end
  return names;
}

INSTANTIATE_TEST_SUITE_P(Layer, LayerSymmetry, testing::ValuesIn(layer_examples()),
                         [](const auto& each) { return each.param; });

/// Number and sign of an unknown, and of its row, seen in a mirror at the middle of the box.
struct Image {
  core::Index number;
  double sign;
};

std::vector<Image> images(const layer::Layer& system) {
  const auto& at = system.unknowns();
  const auto& c = system.columns();
  std::vector<Image> list(system.layout().size(), {-1, 0.0});
  for (int f = 0; f < c.n_faces(); ++f)
    for (int k = 0; k < c.n_layers; ++k) list[at.u(f, k)] = {at.u(c.face(c.n_columns - f), k), -1.0};
  for (int i = 0; i < c.n_columns; ++i) {
    const int mirrored = c.n_columns - 1 - i;
    for (int k = 0; k < c.n_layers; ++k) {
      list[at.omega(i, k + 1)] = {at.omega(mirrored, k + 1), 1.0};
      list[at.p(i, k)] = {at.p(mirrored, k), 1.0};
    }
    list[at.H(i)] = {at.H(mirrored), 1.0};
  }
  if (at.mass_in() >= 0) list[at.mass_in()] = {at.mass_in(), 1.0};
  if (at.mass_left() >= 0) list[at.mass_left()] = {at.mass_right(), 1.0};
  if (at.mass_right() >= 0) list[at.mass_right()] = {at.mass_left(), 1.0};
  return list;
}

/// Both ends of every example are of one kind.
TEST_P(LayerSymmetry, AMirroredBoxHasTheMirroredRows) {
  for (const std::string& settings : {std::string("inflow.momentum=false"), std::string("inflow.momentum=true"),
                                      std::string("model.advection=central")}) {
    auto par = app::make_layer_parameters(small(GetParam(), 15, 6, {"model.name=layer", settings}));
    par.box.base_slope += 0.05;
    const layer::Layer system(par);
    par.box.tilt *= -1.0;
    par.box.base_slope *= -1.0;
    par.inflow.position = par.box.length - par.inflow.position;
    const layer::Layer mirror(par);
    const State state(system, 11);
    const auto image = images(system);
    std::vector<double> y(state.y), yp(state.yp);
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[image[i].number] = image[i].sign * state.y[i];
      yp[image[i].number] = image[i].sign * state.yp[i];
    }
    const auto r = residual_of(mirror, y, yp);
    const auto size = sizes(system.layout(), state.r);
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(r[image[i].number], image[i].sign * state.r[i], 1e-13 * size[i])
          << settings << ": " << system.describe(static_cast<core::Index>(i));
  }
}

/// Gravity enters by its two components alone, each linearly: no angle of the grid is preferred.
TEST_P(LayerSymmetry, GravityActsByItsTwoComponents) {
  auto par = app::make_layer_parameters(small(GetParam(), 12, 5, {"model.name=layer"}));
  par.inflow.along_gravity = false;
  const double g = par.box.gravity;
  const State state(layer::Layer(par), 12);
  const auto under = [&](double gravity, double tilt) {
    par.box.gravity = gravity;
    par.box.tilt = tilt;
    return residual_of(layer::Layer(par), state.y, state.yp);
  };
  const auto none = under(0.0, 0.0), across = under(g, 0.0), along = under(g, 0.5 * std::numbers::pi);
  for (const double tilt : {-2.5, -0.8, 0.2, 1.1}) {
    const auto r = under(g, tilt);
    const auto size = sizes(layer::Layer(par).layout(), r);
    for (std::size_t i = 0; i < r.size(); ++i)
      EXPECT_NEAR(r[i], none[i] + std::cos(tilt) * (across[i] - none[i]) + std::sin(tilt) * (along[i] - none[i]),
                  1e-13 * size[i])
          << tilt;
  }
}

/// A uniform layer whose base, surface and velocities lean by alpha against the grid, in a box that is tilted the other way: its
/// rows are the tangential and the upright part of those of the layer along the grid.
void expect_rows_that_turn_with_the_base(const std::string& base) {
  const int nx = 6, nz = 7;
  const auto level = app::make_layer_parameters(
      small("chute_periodic", nx, nz, {"rheology.rate_speed=0", "rheology.rate_floor=0.3", "box.base_slope=0", base}));
  const layer::Layer aligned(level);
  const auto& at = aligned.unknowns();
  State state(aligned, 13);
  for (int k = 0; k < nz; ++k)
    for (int i = 0; i < nx; ++i) {
      for (auto* v : {&state.y, &state.yp}) {
        (*v)[at.u(i, k)] = (*v)[at.u(0, k)];
        (*v)[at.omega(i, k + 1)] = 0.0;
        (*v)[at.p(i, k)] = (*v)[at.p(0, k)];
        (*v)[at.H(i)] = v == &state.y ? level.initial.thickness : 0.0;
      }
    }
  const auto r = residual_of(aligned, state.y, state.yp);
  const auto size = sizes(aligned.layout(), r);
  for (const double degrees : {20.0, -50.0}) {
    const double alpha = degrees * std::numbers::pi / 180.0, cosine = std::cos(alpha);
    auto par = level;
    par.box.base_slope = std::tan(alpha);
    par.box.tilt += alpha;
    par.grid.cluster_depth /= cosine;
    const layer::Layer leaning(par);
    auto y = state.y, yp = state.yp;
    for (int i = 0; i < nx; ++i) {
      y[at.H(i)] /= cosine;
      for (int k = 0; k < nz; ++k) y[at.u(i, k)] *= cosine, yp[at.u(i, k)] *= cosine;
    }
    const auto turned = residual_of(leaning, y, yp);
    for (int k = 0; k < nz; ++k) {
      const auto u = at.momentum_u(2, k), w = at.momentum_w(2, k + 1);
      const double above = k + 1 < nz ? r[at.momentum_u(2, k + 1)] : 0.0;
      EXPECT_NEAR(turned[u], r[u] / (cosine * cosine), 1e-12 * size[u]) << aligned.describe(u);
      EXPECT_NEAR(turned[w], r[w] + 0.5 * std::tan(alpha) * (r[u] + above), 1e-12 * (size[w] + size[u]))
          << aligned.describe(w);
      EXPECT_NEAR(turned[at.continuity(2, k)], 0.0, 1e-12) << k;
    }
  }
}

TEST(Layer, RowsOfAUniformLayerTurnWithItsBase) {
  expect_rows_that_turn_with_the_base("box.base_slip_length=0");
  expect_rows_that_turn_with_the_base("box.base_slip_length=2e-3");
}

/// Without weight, side walls and base friction the momentum along x of a periodic layer keeps its sum: stresses, pressure and
/// convection through each face leave one volume and enter another. Its rate is read from the rows by a uniform virtual
/// velocity, u = 1 and omega = -slope. On sloping layers without stresses: the shear on upright faces enters the rows along the layer
/// from cell centres and those across it from corners, and its sum vanishes with the truncation error only.
TEST(Layer, MomentumTelescopesWhereThereAreNoSources) {
  struct Variant {
    const char* advection;
    double roughness;  ///< of the surface [m]
  };
  for (const auto& [advection, roughness] :
       {Variant{"model.advection=upwind", 2e-4}, {"model.advection=central", 2e-4}, {"model.advection=upwind", 0.0}}) {
    const int nx = 16, nz = 8;
    auto par = app::make_layer_parameters(small("chute_periodic", nx, nz, {advection, "box.base_slope=0"}));
    par.box.gravity = 0.0;
    par.wall.mu_w = 0.0;
    if (roughness > 0.0) par.law = rheology::Constant{0.0};
    const layer::Layer system(par);
    const auto& at = system.unknowns();
    const double dx = system.columns().dx();
    State state(system, 14);
    auto& [y, yp, r] = state;
    for (int i = 0; i < nx; ++i) {
      y[at.H(i)] = 0.02 + roughness * std::sin(1.7 * i);  // no film, no jump
      y[at.u(i, 0)] = y[at.u(i, 1)] = 0.0;                // nothing pulls at the base
    }
    // omega and dH/dt that follow from u by continuity.
    const auto& z = system.context(0.1, y);
    const auto h = [&](int i, int k) { return z.z[z.at(i, k + 1)] - z.z[z.at(i, k)]; };
    for (int i = 0; i < nx; ++i) {
      double omega = 0.0;
      for (int k = 0; k < nz; ++k) {
        const double in = 0.5 * (h(i - 1, k) + h(i, k)) * y[at.u(i, k)];
        const double out = 0.5 * (h(i, k) + h(i + 1, k)) * y[at.u(i + 1, k)];
        omega -= (out - in) / dx;
        y[at.omega(i, k + 1)] = omega;
      }
      yp[at.H(i)] = omega;
    }
    r = residual_of(system, y, yp);
    const auto& c = system.context(0.1, y);
    double power = 0.0, rate = 0.0, size = 0.0;
    for (int i = 0; i < nx; ++i)
      for (int k = 0; k < nz; ++k) {
        const auto dh_dt = [&](int column) {
          return (c.dz[c.at(column, k + 1)] - c.dz[c.at(column, k)]) * yp[at.H(column)];
        };
        const double mass = 0.5 * par.grains.rho() * (h(i - 1, k) + h(i, k));
        const double mass_rate = 0.5 * par.grains.rho() * (dh_dt(i - 1) + dh_dt(i));
        rate += mass * yp[at.u(i, k)] + mass_rate * y[at.u(i, k)];
        const double slope = (c.z[c.at(i + 1, k + 1)] - c.z[c.at(i - 1, k + 1)]) / (2.0 * dx);
        power += r[at.momentum_u(i, k)] - slope * r[at.momentum_w(i, k + 1)];
        size += std::abs(r[at.momentum_u(i, k)]);
        EXPECT_NEAR(r[at.continuity(i, k)], 0.0, 1e-13);
      }
    EXPECT_GT(size, 50.0 * std::abs(rate)) << "stress and convection should be what must cancel";
    EXPECT_NEAR(power, rate, 1e-13 * size) << advection;
  }
}

}  // namespace
