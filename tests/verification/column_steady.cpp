#include <gtest/gtest.h>

#include <cstdio>

#include "diagnostics/observed_order.hpp"
#include "support/column_run.hpp"

/// The column in its steady state against exact profiles, with the order of its error; a Newtonian film on its way there.
namespace {

using namespace talus;
using tests::degree;

struct Error {
  double L1, Linf, flow;
};

/// Of speeds in the middles of layers, relative to the speed on the surface; of the flow, relative to itself.
template <class Exact>
Error error_of(const tests::ColumnRun& run, const Exact& exact) {
  const auto& at = run.column().heights();
  const double scale = exact.surface_speed();
  Error error{};
  for (int k = 0; k < at.n_layers(); ++k) {
    const double off = std::abs(run.u()[k] - exact.speed(at.centre[k] - at.surface())) / scale;
    error.L1 += off * at.thickness(k) / at.surface();
    error.Linf = std::max(error.Linf, off);
  }
  const auto& par = run.column().parameters();
  error.flow = std::abs(run.flow() * par.grains.rho() * par.box.gap / exact.flux() - 1.0);
  return error;
}

struct Orders {
  double L1, Linf;
};

/// Steady errors on five grids, each half as wide as the one before, printed as a table.
template <class Exact>
Orders orders_of(const char* words, column::Parameters par, double slope, const Exact& exact,
                 std::initializer_list<int> grids) {
  std::printf("%s\nlayers  L1         Linf       flow\n", words);
  std::vector<double> width, L1, Linf;
  par.start = tests::steady_start(par, slope);
  for (const int layers : grids) {
    par.grid.layers = layers;
    tests::ColumnRun run(par, tests::precise());
    run.at(30.0);
    const auto error = error_of(run, exact);
    std::printf("%6d  %.3e  %.3e  %.3e\n", layers, error.L1, error.Linf, error.flow);
    width.push_back(1.0 / layers);
    L1.push_back(error.L1);
    Linf.push_back(error.Linf);
  }
  const Orders orders{diagnostics::fitted_order(width, L1), diagnostics::fitted_order(width, Linf)};
  std::printf("order   %.3f      %.3f\n", orders.L1, orders.Linf);
  return orders;
}

const std::initializer_list<int> grids{25, 50, 100, 200, 400, 800};

TEST(SteadyColumn, WithoutWallsConvergesToBagnoldsFlowAtTheStatedOrders) {
  auto par = tests::table_2(26.0, 0.01, 25, 0.0);
  const auto exact = steady::UniformFlow::at(tests::steady_layer(par).channel, 26.0 * degree, par.thickness);
  const auto uniform = orders_of("Bagnold, uniform", par, 26.0, *exact, grids);
  EXPECT_NEAR(uniform.L1, 2.0, 0.1);
  EXPECT_NEAR(uniform.Linf, 1.5, 0.1);
}

TEST(SteadyColumn, BetweenWallsConvergesToTheExactProfileOfTheSameWallFriction) {
  auto par = tests::table_2(45.0, 0.012, 25);
  const auto exact = steady::RegularisedProfile::at(tests::steady_layer(par), 45.0 * degree, 16000);
  const auto uniform = orders_of("walls, uniform", par, 45.0, *exact, grids);
  EXPECT_NEAR(uniform.L1, 2.0, 0.1);
  EXPECT_NEAR(uniform.Linf, 1.5, 0.1);
  par.grid.spacing = grid::Spacing::clustered;
  par.grid.cluster_depth = 0.003;
  const auto clustered = orders_of("walls, clustered, H0 = 3 mm", par, 45.0, *exact, grids);
  EXPECT_NEAR(clustered.L1, 2.0, 0.1);
  EXPECT_GT(clustered.Linf, 1.5);
}

TEST(SteadyColumn, TendsToTheExactFlowAsWallFrictionSharpens) {
  for (const double u_c : {1e-2, 1e-3, 1e-4, 1e-5}) {
    auto par = tests::table_2(45.0, 0.012, 800);
    par.grid.spacing = grid::Spacing::clustered;
    par.grid.cluster_depth = 0.003;
    par.wall.u_c = u_c;
    par.start = tests::steady_start(par, 45.0);
    const auto exact = steady::UniformFlow::at(tests::steady_layer(par).channel, 45.0 * degree, par.thickness);
    tests::ColumnRun run(par, tests::precise());
    run.at(30.0);
    const double shift = run.surface_speed() - exact->surface_speed();
    std::printf("u_c = %.0e m/s: surface speed off by %.3e m/s\n", u_c, shift);
    EXPECT_NEAR(shift / u_c, 1.1, 0.15);
  }
}
}  // namespace
