#include <gtest/gtest.h>

#include <algorithm>

#include "ida/ida.hpp"
#include "layer/layer.hpp"
#include "support/continued_run.hpp"
#include "support/example_scene.hpp"
#include "support/random_state.hpp"

namespace {

using namespace talus;
using tests::small;

class LayerExample : public testing::TestWithParam<std::string> {};

std::vector<std::string> layer_examples() {
  std::vector<std::string> names;
  for (const auto& each : tests::every_case())
    if (each.model == "layer" && !small(each.scene, 9, 5).box.lid) names.push_back(each.scene);  // else see LayerLid
  return names;
}

TEST_P(LayerExample, MassFluxesTelescope) {
  const layer::Layer system(app::make_layer_parameters(small(GetParam(), 20, 6, {"model.name=layer"})));
  std::vector<double> y, yp, r(system.layout().size());
  tests::RandomState{}.fill(system, 5, y, yp);
  std::fill(yp.begin(), yp.end(), 0.0);
  system.residual(0.1, y, yp, r);
  const auto& par = system.parameters();
  const auto& at = system.unknowns();
  const double mass_of_height = par.grains.rho() * par.box.gap * system.columns().dx();
  double sum = 0.0, size = 0.0;
  for (int i = 0; i < system.columns().n_columns; ++i) {
    sum += mass_of_height * r[at.H(i)];
    size += std::abs(mass_of_height * r[at.H(i)]);
  }
  if (at.mass_in() >= 0) sum -= r[at.mass_in()];
  if (at.mass_left() >= 0) sum += r[at.mass_left()];
  if (at.mass_right() >= 0) sum += r[at.mass_right()];
  EXPECT_LT(std::abs(sum), 1e-14 * size);
}

/// Every number from 0 on belongs to one unknown.
void expect_numbers_of_their_own(const layer::Layer& system) {
  const auto& at = system.unknowns();
  const auto& c = system.columns();
  std::vector<int> owners(system.layout().size(), 0);
  const auto own = [&](core::Index number) {
    if (number >= 0) ++owners.at(number);
  };
  for (int f = 0; f < c.n_faces(); ++f)
    for (int k = 0; k < c.n_layers; ++k) own(at.u(f, k));
  for (int i = 0; i < c.n_columns; ++i) {
    own(at.H(i));
    for (int k = 0; k < c.n_layers; ++k) own(at.omega(i, k + 1)), own(at.p(i, k));
  }
  own(at.mass_in()), own(at.mass_left()), own(at.mass_right());
  for (std::size_t i = 0; i < owners.size(); ++i) EXPECT_EQ(owners[i], 1) << i;
}

TEST_P(LayerExample, EachUnknownHasANumberOfItsOwn) {
  expect_numbers_of_their_own(layer::Layer(app::make_layer_parameters(small(GetParam(), 9, 5, {"model.name=layer"}))));
}

INSTANTIATE_TEST_SUITE_P(Layer, LayerExample, testing::ValuesIn(layer_examples()),
                         [](const auto& each) { return each.param; });

/// Every number is an unknown's own, no wall has a velocity, every row and every column has an entry, every row its own words, and
/// the Jacobian is that of the residual.
void expect_sound(const layer::Parameters& parameters, const std::string& what) {
  SCOPED_TRACE(what);
  const layer::Layer system(parameters);
  expect_numbers_of_their_own(system);
  const auto& box = parameters.box;
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(system.unknowns().u(0, k) < 0, !box.periodic && !box.left_open) << k;
    EXPECT_EQ(system.unknowns().u(parameters.grid.columns, k) < 0, !box.periodic && !box.right_open) << k;
  }
  const auto& pattern = system.pattern();
  std::vector<int> in_row(pattern.n(), 0);
  for (const auto row : pattern.rows()) ++in_row[row];
  std::set<std::string> words;
  for (core::Index i = 0; i < pattern.n(); ++i) {
    EXPECT_GT(in_row[i], 0) << system.describe(i);
    EXPECT_LT(pattern.column_starts()[i], pattern.column_starts()[i + 1]) << system.describe(i);
    EXPECT_TRUE(words.insert(system.describe(i)).second) << system.describe(i);
  }
  std::vector<double> y, yp;
  tests::RandomState{}.fill(system, 7, y, yp);
  core::Index worst = -1;
  EXPECT_LT(tests::jacobian_error(system, 0.1, y, yp, 50.0, worst), 1e-6) << system.describe(worst);
}

/// Walls in place of the open ends of the examples: no velocity on their faces, no mass through them.
TEST(LayerWall, HasNoVelocityNoEmptyRowAndAnExactJacobian) {
  using Settings = std::vector<std::string>;
  for (const Settings& ends :
       {Settings{"box.left=wall"}, Settings{"box.right=wall"}, Settings{"box.left=wall", "box.right=wall"},
        Settings{"box.left=wall", "box.right=wall", "box.end_walls=no_slip"}}) {
    for (const char* inflow : {"inflow.rate=0.0046", "inflow.rate=0"}) {
      Settings settings = ends;
      settings.emplace_back(inflow);
      expect_sound(app::make_layer_parameters(small("heap_q46", 9, 5, settings)), testing::PrintToString(settings));
    }
  }
}

/// Each kind of base and lid, between walls of each kind and without, on a base that leans against the grid.
TEST(LayerLid, HasNoEmptyRowAndAnExactJacobian) {
  const std::string no_slip = "no_slip", free_slip = "free_slip";
  for (const auto& walls : {std::string(), free_slip, no_slip}) {
    for (const auto& lid : {no_slip, free_slip}) {
      for (const auto& base : {no_slip, free_slip}) {
        std::vector<std::string> settings{"box.base_slope=0.2",
                                          "wall.mu_w=0.4",
                                          base == no_slip ? "box.base_speed=0.1" : "box.base_speed=0",
                                          lid == no_slip ? "box.lid_speed=0.1" : "box.lid_speed=0",
                                          "box.lid=" + lid,
                                          "box.base=" + base};
        if (!walls.empty()) {
          settings.insert(settings.end(),
                          {"box.periodic=false", "box.left=wall", "box.right=wall", "box.end_walls=" + walls});
        }
        expect_sound(app::make_layer_parameters(small("shear_cell", 7, 5, settings)), testing::PrintToString(settings));
      }
    }
  }
}

class Push final : public layer::Forcing {
 public:
  [[nodiscard]] layer::Vector force(int f, int k, double t) const override { return {10.0 * f, 7.0 * k - t}; }
  [[nodiscard]] double base_speed(int f, double) const override { return 0.1 * f; }
  [[nodiscard]] double lid_speed(int f, double) const override { return 0.2 * f; }
  [[nodiscard]] double lid_pressure(double t) const override { return 100.0 * t; }
  [[nodiscard]] double surface_pressure(int i, double) const override { return 3.0 * i; }
  [[nodiscard]] layer::Vector surface_pull(int f, double) const override { return {1.0 + f, 2.0}; }
};

/// A fluid in place of grains, and what is given, under a free surface and under a lid, between open ends, walls and joined ones.
TEST(LayerGiven, FluidsAndForcesHaveAnExactJacobian) {
  for (const std::string scene : {"heap_no_walls", "chute_periodic", "shear_cell"}) {
    for (const bool fluid : {false, true}) {
      auto par = app::make_layer_parameters(small(scene, 7, 5));
      par.forcing = std::make_shared<Push>();
      if (fluid) par.fluid = rheology::Newtonian{2.0};
      expect_sound(par, scene);
      if (par.box.periodic) continue;
      par.box.left_open = par.box.right_open = false;
      par.box.end_walls = experiment::Contact::no_slip;
      expect_sound(par, scene + " between walls");
    }
  }
}

/// The cell whose volume has no row keeps it as the others do, and what is between walls and lid stays there.
TEST(LayerLid, VolumeOfTheCellWithoutARowIsKept) {
  for (const char* end : {"box.periodic=true", "box.periodic=false"}) {
    const auto scene = small("shear_cell", 8, 6, {end, "box.left=wall", "box.right=wall", "box.tilt=30"});
    const layer::Layer system(app::make_layer_parameters(scene));
    core::Observer nobody;
    std::vector<double> y(system.layout().size()), yp(y);
    system.initial_state(0.0, y, yp);
    ida::Ida integrator(system, app::make_integrator_options(scene));
    integrator.start(0.0, y, yp);
    integrator.advance(0.1, nobody);
    const auto now = integrator.current().y;
    const auto& at = system.unknowns();
    const auto read = [&](core::Index index) { return fv::read(now, index); };
    const double h = scene.initial.thickness / 6.0, dx = system.columns().dx();
    double fastest = 0.0;
    for (int f = 0; f < 8; ++f)
      for (int k = 0; k < 6; ++k) fastest = std::max(fastest, std::abs(read(at.u(f, k))));
    EXPECT_GT(fastest, 1e-5);
    for (int i = 0; i < 8; ++i) {
      EXPECT_NEAR(now[at.H(i)], scene.initial.thickness, 1e-15);
      for (int k = 0; k < 6; ++k) {
        const double out =
            (read(at.u(i + 1, k)) - read(at.u(i, k))) * h / dx + read(at.omega(i, k + 1)) - read(at.omega(i, k));
        EXPECT_NEAR(out, 0.0, 1e-10 * fastest) << i << " " << k;
      }
    }
  }
}

TEST(LayerLid, ClosesTheBox) {
  auto par = app::make_layer_parameters(small("shear_cell", 4, 5));
  par.box.periodic = false;
  EXPECT_THROW(layer::Layer{par}, std::invalid_argument);
  par.box.left_open = false;
  EXPECT_THROW(layer::Layer{par}, std::invalid_argument);
  par.box.right_open = false;
  EXPECT_NO_THROW(layer::Layer{par});
}

/// Deep enough to be no film and without jumps, but rough.
double rough_height(int i) { return 0.02 + 2e-4 * std::sin(1.7 * i) + 1e-4 * std::cos(0.9 * i * i); }

TEST(Layer, UniformFlowStaysUniformOnAMovingGrid) {
  auto par = app::make_layer_parameters(small("chute_periodic", 24, 7));
  par.box.gravity = 0.0;  // no weight, no friction: nothing but inertia
  par.box.base_slope = 0.0;
  par.wall.mu_w = 0.0;
  par.law = rheology::Constant{0.0};
  const layer::Layer system(par);
  const auto& at = system.unknowns();
  const int nx = 24, nz = 7;
  const double U = 0.7, dx = system.columns().dx();
  std::vector<double> y(system.layout().size(), 0.0), yp(y), r(y);
  for (int i = 0; i < nx; ++i) {
    y[at.H(i)] = rough_height(i);
    yp[at.H(i)] = -U * (rough_height((i + 1) % nx) - rough_height((i + nx - 1) % nx)) / (2.0 * dx);
  }
  const auto& context = system.context(0.0, y);
  const auto slope = [&](const std::vector<double>& z, const std::vector<double>& by, int i, int k) {
    const auto left = context.at(i - 1, k), right = context.at(i + 1, k);
    if (&z == &by) return (z[right] - z[left]) / (2.0 * dx);
    return (z[right] * by[at.H((i + 1) % nx)] - z[left] * by[at.H((i + nx - 1) % nx)]) / (2.0 * dx);
  };
  for (int i = 0; i < nx; ++i)
    for (int k = 0; k < nz; ++k) {
      y[at.u(i, k)] = U;
      y[at.omega(i, k + 1)] = -U * slope(context.z, context.z, i, k + 1);
      yp[at.omega(i, k + 1)] = -U * slope(context.dz, yp, i, k + 1);
    }
  system.residual(0.0, y, yp, r);
  const double inertia = par.grains.rho() * U * U;  // [Pa], the size of the terms that must cancel
  for (core::Index i = 0; i < system.layout().size(); ++i)
    EXPECT_LT(std::abs(r[i]), 1e-13 * inertia) << system.describe(i);
}

TEST(Layer, LevelSurfaceOverATiltedBaseIsAtRestToRoundOff) {
  auto par = app::make_layer_parameters(small("heap_no_walls", 24, 7));
  const layer::Layer system(par);
  const auto& at = system.unknowns();
  std::vector<double> y(system.layout().size(), 0.0), yp(y), r(y);
  const double weight = par.grains.rho() * par.box.gravity * std::cos(par.box.tilt);
  for (int i = 0; i < 24; ++i) y[at.H(i)] = 0.01 + std::tan(par.box.tilt) * system.columns().x_centre(i);
  const auto& context = system.context(0.0, y);
  for (int i = 0; i < 24; ++i)
    for (int k = 0; k < 7; ++k)
      y[at.p(i, k)] = weight * (y[at.H(i)] - 0.5 * (context.z[context.at(i, k)] + context.z[context.at(i, k + 1)]));
  system.residual(0.0, y, yp, r);
  for (int f = 1; f < 24; ++f)
    for (int k = 0; k < 7; ++k) EXPECT_LT(std::abs(r[at.u(f, k)]), 1e-13 * weight) << system.describe(at.u(f, k));
  for (int i = 0; i < 24; ++i)
    for (int k = 1; k <= 7; ++k) EXPECT_LT(std::abs(r[at.momentum_w(i, k)]), 1e-13 * weight);
}

class LayerCheckpoint : public testing::TestWithParam<const char*> {};

TEST_P(LayerCheckpoint, ARunContinuedFromItEqualsTheOneThatWroteItBitByBit) {
  const auto scene = small("heap_q46", 30, 8, {std::string("integrator.linear_solver=") + GetParam()});
  const layer::Layer system(app::make_layer_parameters(scene));
  tests::expect_same_bits_when_continued(system, app::make_integrator_options(scene), 0.8, 1.2);
}

INSTANTIATE_TEST_SUITE_P(EachSolver, LayerCheckpoint,
                         testing::Values("automatic", "klu", "umfpack", "mumps", "banded", "condensed"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
