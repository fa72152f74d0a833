#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "support/two_fluid.hpp"
#include "two_fluid/fields.hpp"
#include "two_fluid/grain_flux.hpp"

/// What the two-fluid model alone can promise.
namespace {

using namespace talus;
using tests::heap_of_two_fluids, tests::Settings;
using two_fluid::TwoFluid;
using State = tests::TwoFluidState;

/// Each switch of the model.
const std::vector<Settings> switches{
    Settings{"two_fluid.transport=upwind"},
    {"two_fluid.transport=limited"},
    {"two_fluid.cells=reachable", "two_fluid.reach_margin=0"},
    {"two_fluid.averaging=harmonic"},
    {"two_fluid.base_film=true"},
    {"two_fluid.direction=base_normal"},
    {"two_fluid.direction=settling"},
    {"two_fluid.direction=settling", "two_fluid.jet_segregation=true"},
    {"two_fluid.direction=settling", "box.tilt=-20", "inflow.position=0.4"},
    {"two_fluid.jet=free_fall"},
    {"two_fluid.jet=free_fall", "two_fluid.cells=reachable", "two_fluid.reach_margin=0"},
    {"two_fluid.jet=free_fall", "box.left=wall", "two_fluid.jet_clearance=0.2"},
    {"two_fluid.sharpening=none"},
    {"two_fluid.sharpening=counter_gradient"},
    {"model.advection=none"},
    {"model.advection=central"},
    {"two_fluid.x_grading=3", "two_fluid.z_grading=5"},
    {"box.left=wall"},
    {"two_fluid.jet_clearance=0.2"},
    {"box.tilt=-20", "inflow.position=0.4"}};

/// The Jacobian with each switch of the model.
TEST(TwoFluid, JacobianIsExactWithEachSwitch) {
  for (const Settings& settings : switches) {
    const TwoFluid system(heap_of_two_fluids(9, 5, settings));
    for (const unsigned seed : {1U, 2U}) {
      const State state(system, seed);
      core::Index worst = 0;
      EXPECT_LT(tests::jacobian_error(system, 0.1, state.y, state.yp, 50.0, worst), 1e-6)
          << settings[0] << ", seed " << seed << ": " << system.describe(worst);
    }
  }
}

/// On a grid that is deep enough for places inside it, as `EveryModel` does it for small ones.
TEST(TwoFluid, PlacesInPacksGiveTheBitsOfPlacesOneByOneWithEachSwitch) {
  for (const Settings& settings : switches) {
    const TwoFluid system(heap_of_two_fluids(23, 17, settings));
    State state(system, 7);
    auto one_by_one = state.r;
    ASSERT_EQ(fegetexcept(), 0);
    feenableexcept(FE_DIVBYZERO);  // what asks for places one by one
    system.residual(0.1, state.y, state.yp, one_by_one);
    fedisableexcept(FE_DIVBYZERO);
    for (core::Index i = 0; i < system.layout().size(); ++i)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(state.r[i]), std::bit_cast<std::uint64_t>(one_by_one[i]))
          << settings[0] << ": " << system.describe(i);
    int inside = 0;
    for (const auto [i, k] : system.mesh().cells()) inside += int(system.mesh().is_inside(i, k));
    EXPECT_EQ(inside > 0, settings[0] != "two_fluid.x_grading=3")
        << settings[0];  // layers of other heights are not alike
  }
}

TEST(TwoFluid, EachUnknownHasANumberOfItsOwn) {
  for (const Settings& settings : {Settings{},
                                   {"box.periodic=true", "inflow.rate=0"},
                                   {"two_fluid.jet=free_fall"},
                                   {"two_fluid.cells=reachable", "two_fluid.reach_margin=0"}}) {
    const TwoFluid system(heap_of_two_fluids(15, 9, settings));
    const auto& at = system.unknowns();
    std::vector<int> owners(system.layout().size(), 0);
    const auto own = [&](core::Index number) {
      if (number >= 0) ++owners.at(number);
    };
    for (const auto [f, k] : system.mesh().faces()) own(at.u(f, k));
    for (const auto [i, k] : system.mesh().interfaces()) own(at.w(i, k));
    for (const auto [i, k] : system.mesh().cells()) own(at.phi(i, k)), own(at.p(i, k));
    for (const auto number : {at.mass_in(), at.mass_left(), at.mass_right(), at.mass_top()}) own(number);
    for (int line = 0; line < at.n_heaps(); ++line) own(at.heap(line));
    for (std::size_t i = 0; i < owners.size(); ++i) EXPECT_EQ(owners[i], 1) << i;
  }
}

/// What enters or leaves is all that changes: grains and volume.
TEST(TwoFluid, FluxesOfGrainsAndVolumeTelescope) {
  for (const Settings& settings : {Settings{},
                                   {"two_fluid.transport=upwind"},
                                   {"two_fluid.sharpening=counter_gradient"},
                                   {"two_fluid.direction=settling", "two_fluid.jet_segregation=true"},
                                   {"two_fluid.cells=reachable", "two_fluid.reach_margin=0"},
                                   {"two_fluid.jet=free_fall", "two_fluid.direction=settling"},
                                   {"two_fluid.jet=free_fall", "two_fluid.cells=reachable"},
                                   {"two_fluid.z_grading=4"}}) {
    const TwoFluid system(heap_of_two_fluids(20, 12, settings));
    State state(system, 5);
    std::ranges::fill(state.yp, 0.0);
    system.residual(0.1, state.y, state.yp, state.r);
    const auto& at = system.unknowns();
    const auto& g = system.mesh().grid();
    const auto context = system.context(0.1);
    double grains = 0.0, volume = system.mesh().fall().n_lines > 0 ? context.poured : 0.0, size = 0.0;
    for (const auto [i, k] : system.mesh().cells()) {
      grains += state.r[at.phi(i, k)];
      volume += state.r[at.continuity(i, k)];
      size += std::abs(state.r[at.phi(i, k)]);
    }
    const auto& mesh = system.mesh();
    for (const auto [f, k] : mesh.faces())
      volume -= g.dz(k) * state.y[at.u(f, k)] * (int(mesh.has_cell(f - 1, k)) - int(mesh.has_cell(f, k)));
    for (const auto [i, k] : mesh.interfaces())
      volume -= g.dx(i) * state.y[at.w(i, k)] * (int(mesh.has_cell(i, k - 1)) - int(mesh.has_cell(i, k)));
    const double across = system.parameters().grains.rho() * system.parameters().box.gap;
    grains *= across;
    grains -= state.r[at.mass_in()];
    for (const auto out : {at.mass_left(), at.mass_right(), at.mass_top()}) grains += state.r[out];
    EXPECT_LT(std::abs(grains), 1e-14 * across * size);
    EXPECT_LT(std::abs(volume), 1e-14);
  }
}

/// Without forces the momentum along x of a closed ring changes by nothing, however grains move through it: rho du/dt + u drho/dt sums to
/// zero where drho/dt is what transport, segregation included, says.
TEST(TwoFluid, MomentumTelescopesWithTheMassFluxOfTransport) {
  for (const char* transport : {"two_fluid.transport=limited", "two_fluid.transport=upwind"}) {
    auto par = heap_of_two_fluids(12, 9, {transport, "box.periodic=true", "inflow.rate=0", "two_fluid.z_grading=3"});
    par.box.gravity = 0.0;
    par.wall.mu_w = 0.0;
    par.law = rheology::Constant{0.0};
    par.numerics.upwind_speed = 0.0;  // it leaks through a top on which w is zero
    par.numerics.air = {.rho = 0.0, .eta = 0.0, .drag_viscosity = 0.0};
    const TwoFluid system(par);
    const auto& at = system.unknowns();
    const auto& g = system.mesh().grid();
    State state(system, 3);
    for (int i = 0; i < g.n_columns(); ++i) state.y[at.w(i, g.n_layers())] = 0.0;
    std::ranges::fill(state.yp, 0.0);
    system.residual(0.1, state.y, state.yp, state.r);
    const double rho = par.grains.rho();
    double momentum = 0.0, size = 0.0;
    for (const auto [f, k] : system.mesh().faces()) {
      const double mass_rate = -0.5 * rho * (state.r[at.phi(f - 1, k)] + state.r[at.phi(f, k)]);
      momentum += state.r[at.u(f, k)] - state.y[at.u(f, k)] * mass_rate;
      size += std::abs(state.r[at.u(f, k)]);
    }
    EXPECT_GT(size, 1.0);
    EXPECT_LT(std::abs(momentum), 1e-13 * size) << transport;
  }
}

/// Where the flux of grains is of second order its row reads the cell two upstream; elsewhere that cell is no entry of the matrix.
TEST(TwoFluid, FarCellsAreReadWhereTheFluxIsOfSecondOrder) {
  constexpr double bump = 1e-3;
  for (const char* transport : {"limited", "jet", "upwind"}) {
    const TwoFluid system(heap_of_two_fluids(20, 10, {std::string("two_fluid.transport=") + transport}));
    const auto& at = system.unknowns();
    const auto& g = system.mesh().grid();
    std::vector<double> y(system.layout().size(), 0.0), yp(y), r(y), bumped(y);
    for (const auto [f, k] : system.mesh().faces()) y[at.u(f, k)] = 0.5;
    for (const auto [i, k] : system.mesh().cells()) y[at.phi(i, k)] = 0.1 + 0.02 * i + 0.01 * k;
    system.residual(0.1, y, yp, r);
    int n_read = 0;
    for (const auto [i, k] : system.mesh().cells()) {
      if (i + 2 >= g.n_columns()) continue;
      const double x = g.x_nodes[i + 2], z = g.z_centre(k);
      const auto& jet = system.mesh().jet();
      const bool in_jet = jet.in_corridor(x, z) && jet.omega(x, z, 0.0) < 1.0;
      const bool reads = *transport == 'l' || (*transport == 'j' && in_jet);
      auto& phi = y[at.phi(i, k)];
      phi += bump;
      system.residual(0.1, y, yp, bumped);
      phi -= bump;
      EXPECT_EQ(bumped[at.phi(i + 2, k)] != r[at.phi(i + 2, k)], reads) << transport << ' ' << x << ' ' << z;
      const bool is_entry = system.pattern().find(at.phi(i + 2, k), at.phi(i, k)) >= 0;
      EXPECT_TRUE(is_entry || !reads);
      EXPECT_FALSE(is_entry && !system.mesh().limits_at(x, z));
      n_read += int(reads);
    }
    EXPECT_EQ(n_read > 0, *transport != 'u');
  }
}

TEST(TwoFluid, LevelGrainsUnderAirAreAtRestToRoundOff) {
  const TwoFluid system(heap_of_two_fluids(
      8, 12, {"box.tilt=0", "inflow.rate=0", "model.initial_thickness=0.1", "box.left=wall", "box.right=wall"}));
  std::vector<double> y(system.layout().size()), yp(y), r(y);
  system.initial_state(0.0, y, yp);
  system.residual(0.0, y, yp, r);
  const double leak = system.parameters().numerics.upwind_speed * system.mesh().grid().dx(0);
  for (core::Index i = 0; i < system.layout().size(); ++i)
    EXPECT_LT(std::abs(r[i]), system.layout().field(i).name == "phi" ? leak : 1e-12) << system.describe(i);
}

/// Air has no weight in air: where nothing is poured yet, nothing moves through open edges of the box or of the cells.
TEST(TwoFluid, AirAloneIsAtRestBetweenOpenEdges) {
  for (const Settings& settings :
       {Settings{}, {"two_fluid.cells=reachable", "two_fluid.reach_margin=0"}, {"two_fluid.air_density=100"}}) {
    const TwoFluid system(heap_of_two_fluids(20, 10, settings));
    std::vector<double> y(system.layout().size()), yp(y), r(y);
    system.initial_state(0.0, y, yp);
    system.residual(0.0, y, yp, r);
    for (core::Index i = 0; i < system.layout().size(); ++i) EXPECT_EQ(r[i], 0.0) << system.describe(i);
  }
}

/// A heap under the steepest surface, the jet and the inlet lie in the cells that exist; far air does not. With a wide margin all cells exist.
TEST(TwoFluid, ReachableCellsHoldTheHeapAndTheJet) {
  const auto reachable = [](const char* margin) {
    return heap_of_two_fluids(60, 30, {"two_fluid.cells=reachable", std::string("two_fluid.reach_margin=") + margin});
  };
  const auto par = reachable("0.02");
  const TwoFluid system(par);
  const auto& mesh = system.mesh();
  const auto& g = mesh.grid();
  EXPECT_NEAR(*par.numerics.reach.slope, 48.8126 * std::numbers::pi / 180.0, 1e-5);
  const double rise = std::tan(*par.numerics.reach.slope - par.box.tilt);
  int missing = 0;
  for (int i = 0; i < g.n_columns(); ++i) {
    for (int k = 0; k < g.n_layers(); ++k) {
      const double x = g.x_centre(i), z = g.z_centre(k),
                   jet = par.inflow.position + (par.box.height - z) * std::tan(par.box.tilt);
      const bool in_heap = x > jet && z < (par.box.length - x) * rise, in_jet = std::abs(x - jet) < 0.02;
      const bool far = x > jet + 0.1 && z > (par.box.length - x) * rise + 0.04;
      EXPECT_TRUE(mesh.has_cell(i, k) || !(in_heap || in_jet)) << x << ' ' << z;
      EXPECT_FALSE(mesh.has_cell(i, k) && far) << x << ' ' << z;
      if (!mesh.has_cell(i, k)) ++missing;
    }
  }
  EXPECT_GT(missing, 700);
  EXPECT_EQ(TwoFluid(reachable("1")).mesh().cells().size(), 1800U);
}

/// Transport by the jet's rule is first order without a jet, and second order where all is jet.
TEST(TwoFluid, TransportIsOfSecondOrderInTheJetRegionAlone) {
  const auto residual = [](const char* transport, Settings settings) {
    settings.push_back(std::string("two_fluid.transport=") + transport);
    const TwoFluid system(heap_of_two_fluids(12, 9, settings));
    State state(system, 6);
    if (system.unknowns().heap() >= 0) state.y[system.unknowns().heap()] = -10.0;
    system.residual(0.1, state.y, state.yp, state.r);
    return state.r;
  };
  const Settings no_jet{"inflow.rate=0"}, all_jet{"two_fluid.jet_margin=10"};
  EXPECT_EQ(residual("jet", no_jet), residual("upwind", no_jet));
  EXPECT_EQ(residual("jet", all_jet), residual("limited", all_jet));
  EXPECT_NE(residual("jet", all_jet), residual("upwind", all_jet));
}

/// Grains in still air settle along gravity, whichever way the base slopes; along the base they do so by the share of air in the cell beneath
/// the giver, and not at all over grains or on the base. In the jet region they settle where the scene says so.
TEST(TwoFluid, GrainsSettleAlongGravityButNotAlongTheBaseOverGrains) {
  for (const Settings& tilt : {Settings{"box.tilt=29.2"}, Settings{"box.tilt=-20", "inflow.position=0.4"}}) {
    for (const bool in_jet : {false, true}) {
      Settings settings = tilt;
      settings.push_back("two_fluid.direction=settling");
      settings.push_back(std::string("two_fluid.jet_segregation=") + (in_jet ? "true" : "false"));
      const TwoFluid system(heap_of_two_fluids(20, 10, settings));
      const auto context = system.context(0.0);
      const double phi = 0.2, above_all = -10.0, under_all = 10.0;
      const two_fluid::Row<double> cloud{phi, phi, phi, phi};
      const int f = 8, k = 6;
      const auto along = [&](int layer, double beneath, double heap_height) {
        return two_fluid::grain_flux_x(context, f, layer, 0.0, cloud, beneath, heap_height);
      };
      const double up = two_fluid::grain_flux_z(context, f, k, 0.0, cloud, under_all), free = along(k, 0.0, under_all);
      const double tangent = -std::tan(system.parameters().box.tilt);
      EXPECT_LT(up, -1e-3);
      EXPECT_NEAR(free / up, tangent, 1e-3 * std::abs(tangent));
      EXPECT_NEAR(along(k, 0.5, under_all), 0.5 * free, 1e-3 * std::abs(free));
      EXPECT_EQ(along(k, 1.0, under_all), 0.0);
      EXPECT_EQ(along(0, 0.0, under_all), 0.0);
      int n_jet = 0;
      for (int i = 0; i < 20; ++i) {
        if (!system.mesh().jet().in_corridor(system.mesh().grid().x_centre(i), system.mesh().grid().z_nodes[k]))
          continue;
        ++n_jet;
        EXPECT_EQ(two_fluid::grain_flux_z(context, i, k, 0.0, cloud, above_all), in_jet ? up : 0.0);
      }
      EXPECT_GT(n_jet, 0);
    }
  }
}

/// A cell of grains under one of air: what the row of phi of the lower cell's right neighbour reads is the cell beneath its giver.
TEST(TwoFluid, WhereGrainsSettleTheRowReadsTheCellBeneathTheGiver) {
  for (const bool left : {true, false}) {
    const Settings tilt = left ? Settings{"box.tilt=29.2"} : Settings{"box.tilt=-20", "inflow.position=0.4"};
    for (const char* direction : {"settling", "gravity"}) {
      Settings settings = tilt;
      settings.push_back(std::string("two_fluid.direction=") + direction);
      const TwoFluid system(heap_of_two_fluids(20, 10, settings));
      const auto& at = system.unknowns();
      const int i = 17, k = 4, taker = left ? i + 1 : i - 1;
      EXPECT_EQ(system.pattern().find(at.phi(taker, k), at.phi(i, k - 1)) >= 0, *direction == 's') << direction;
      EXPECT_LT(system.pattern().find(at.phi(left ? i - 1 : i + 1, k), at.phi(i, k - 1)), 0) << direction;
    }
  }
}

/// Left and right are alike: box, cells, state and residual in the mirror.
void mirror_box(const Settings& settings) {
  auto par = heap_of_two_fluids(11, 7, settings);
  const TwoFluid system(par);
  par.box.tilt *= -1.0;
  par.inflow.position = par.box.length - par.inflow.position;
  par.grid.x_ratio = 1.0 / par.grid.x_ratio;
  const TwoFluid mirror(par);
  const State state(system, 4);
  std::vector<double> y(state.y.size()), yp(y), r(y), expected(y);
  const auto& a = system.unknowns();
  const auto& b = mirror.unknowns();
  const auto move = [&](core::Index from, core::Index to, double sign, double row_sign) {
    y[to] = sign * state.y[from];
    yp[to] = sign * state.yp[from];
    expected[to] = row_sign * state.r[from];
  };
  const int nx = 11;
  for (const auto [f, k] : system.mesh().faces()) move(a.u(f, k), b.u(nx - f, k), -1.0, -1.0);
  for (const auto [i, k] : system.mesh().interfaces()) move(a.w(i, k), b.w(nx - 1 - i, k), 1.0, 1.0);
  for (const auto [i, k] : system.mesh().cells()) {
    move(a.phi(i, k), b.phi(nx - 1 - i, k), 1.0, 1.0);
    move(a.p(i, k), b.p(nx - 1 - i, k), 1.0, 1.0);
  }
  move(a.mass_in(), b.mass_in(), 1.0, 1.0), move(a.mass_top(), b.mass_top(), 1.0, 1.0);
  move(a.mass_left(), b.mass_right(), 1.0, 1.0), move(a.mass_right(), b.mass_left(), 1.0, 1.0);
  for (int line = 0; line < a.n_heaps(); ++line) move(a.heap(line), b.heap(a.n_heaps() - 1 - line), 1.0, 1.0);
  mirror.residual(0.1, y, yp, r);
  double largest = 0.0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (core::Index i = 0; i < mirror.layout().size(); ++i)
    EXPECT_NEAR(r[i], expected[i], 1e-12 * largest) << mirror.describe(i);
}

TEST(TwoFluid, AMirroredBoxHasTheMirroredRows) {
  mirror_box({"two_fluid.x_grading=2"});
  mirror_box({"two_fluid.cells=reachable", "two_fluid.reach_margin=0"});
  mirror_box({"two_fluid.direction=settling", "two_fluid.jet_segregation=true"});
  mirror_box({"two_fluid.direction=settling", "two_fluid.jet=free_fall"});
}

/// However the inlet falls on the columns, what is poured is what the scene says.
TEST(TwoFluid, TheInletPoursItsFlow) {
  for (const int columns : {9, 20, 60, 61}) {
    const TwoFluid system(heap_of_two_fluids(columns, 5));
    const auto& g = system.mesh().grid();
    const auto context = system.context(10.0);
    const auto& n = system.parameters().numerics;
    double mass = 0.0;
    for (int i = 0; i < columns; ++i)
      mass += g.dx(i) * system.mesh().inlet_share(i) * context.inlet_speed * n.inlet_fraction * context.grains_across();
    EXPECT_NEAR(mass, 0.0046, 1e-15) << columns;
  }
}

}  // namespace
