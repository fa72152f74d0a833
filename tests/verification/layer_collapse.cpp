#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/errors.hpp"
#include "ida/ida.hpp"
#include "support/layer_cases.hpp"
#include "support/table.hpp"

/// A granular column that collapses on a level, rough base, without side walls: its run-out against its aspect ratio.
namespace {

using namespace talus;

constexpr double half_width = 0.01;  // of the column, r_0 [m]
constexpr double film = 1e-4;        // on the base before the column falls [m]

struct RunOut {
  double reach;   ///< (r - r_0)/r_0, r where the deposit is 2 film thicknesses high
  double height;  ///< of the deposit in its middle over r_0
  long steps, newton_failures;
};

/// Half a column of height a r_0 beside a wall, `across` columns of the grid a half width.
layer::Parameters box(const rheology::Law& law, double a, int across) {
  const double length = half_width * (2.0 + 3.0 * a);
  const int columns = static_cast<int>(std::lround(across * length / half_width)), layers = 12;
  auto par = tests::periodic_layer(length, film, 0.0, columns, layers);
  par.box.periodic = false;
  par.box.left_open = false;
  par.grains = rheology::grains(2500.0, 0.6, 1.43e-4);
  par.law = law;
  par.regularisation = {.p_0 = 0.01, .rate_floor = 0.0, .rate_speed = 1e-3, .eta_max = 1e4, .cap = rheology::Cap::hard};
  par.numerics.film = film;
  par.grid.cluster_depth = half_width;
  par.atol_height = 1e-7;
  return par;
}

/// Width over which the edge of a column of aspect ratio a falls, in half widths: two columns of the coarsest grid, and wider where
/// its slope would else be above 6, 80 degrees.
double smooth_edge(double a) { return std::max(1.0 / 3.0, a / 4.0); }

/// The standing column under its own weight; its edge is a smooth step about r_0.
std::vector<double> standing(const layer::Layer& system, double a, double edge) {
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  const auto& c = system.columns();
  const auto& at = system.unknowns();
  for (int i = 0; i < c.n_columns; ++i) {
    const double s = std::clamp(0.5 + (half_width - c.x_centre(i)) / (edge * half_width), 0.0, 1.0);
    y[at.H(i)] = film + (a * half_width - film) * s * s * (3.0 - 2.0 * s);
  }
  const auto& context = system.context(0.0, y);
  const double weight = system.parameters().grains.rho() * system.parameters().box.gravity;
  for (int i = 0; i < c.n_columns; ++i)
    for (int k = 0; k < c.n_layers; ++k) {
      const double middle = 0.5 * (context.z[context.at(i, k)] + context.z[context.at(i, k + 1)]);
      y.at(at.p(i, k)) = weight * (y[at.H(i)] - middle);
    }
  return y;
}

/// Where the surface falls through `level` [m] for the last time, between the columns' middles.
double front(const layer::Layer& system, std::span<const double> y, double level) {
  const auto& c = system.columns();
  const auto H = [&](int i) { return y[system.unknowns().H(i)]; };
  for (int i = c.n_columns - 2; i >= 0; --i)
    if (H(i) > level) return c.x_centre(i) + c.dx() * std::min(1.0, (H(i) - level) / (H(i) - H(i + 1)));
  return 0.0;
}

/// After six times sqrt(h_0/g), when the front has come to rest but for creep.
RunOut collapse(const rheology::Law& law, double a, int across, double edge) {
  const layer::Layer system(box(law, a, across));
  const auto y = standing(system, a, edge);
  ida::Ida integrator(system);
  core::Observer nobody;
  integrator.start(0.0, y, std::vector<double>(y.size(), 0.0));
  integrator.advance(6.0 * std::sqrt(a * half_width / system.parameters().box.gravity), nobody);
  const auto now = integrator.current();
  return {front(system, now.y, 2.0 * film) / half_width - 1.0, now.y[system.unknowns().H(0)] / half_width,
          static_cast<long>(now.statistics.steps), static_cast<long>(now.statistics.newton_failures)};
}

/// Published run-outs of columns without side walls (Lagree, Staron & Popinet 2011).
double published(double a) { return a < 7.0 ? 2.2 * a : 3.9 * std::pow(a, 0.7); }

const rheology::Law literature = rheology::classical(0.32, 0.60, 0.40);
const rheology::Law table_1 =
    rheology::partially_regularised(rheology::classical(0.342, 0.557, 0.069), 0.05, 1.9, 0.004);

const std::vector<std::string> heads{
    "law",    "a",     "edge over half width", "columns a half width", "run-out", "published",
    "height", "steps", "Newton fails"};

double run(tests::Table& table, const std::string& name, double a, int across) {
  const auto r = collapse(name == "table 1" ? table_1 : literature, a, across, smooth_edge(a));
  table.row({name, a, smooth_edge(a), double(across), r.reach, published(a), r.height, double(r.steps),
             double(r.newton_failures)});
  return r.reach;
}

TEST(LayerCollapse, RunOutAgainstAspectRatio) {
  tests::Table table("layer_collapse", heads);
  for (const char* name : {"table 1", "literature"}) {
    std::vector<double> ratios, reaches;
    for (const double a : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
      const double reach = run(table, name, a, 12);
      EXPECT_LT(reach, 1.1 * published(a)) << name << " " << a;
      if (std::string(name) == "literature") { EXPECT_GT(reach, 0.75 * published(a)) << a; }
      ratios.push_back(a);
      reaches.push_back(reach);
    }
    // As a at first, slower the taller.
    const auto power = [&](std::size_t i) {
      return std::log(reaches[i + 1] / reaches[i]) / std::log(ratios[i + 1] / ratios[i]);
    };
    EXPECT_NEAR(power(0), 1.0, 0.1) << name;
    EXPECT_NEAR(power(4), 0.7, 0.15) << name;
  }
}

TEST(LayerCollapse, RunOutMovesLittleUnderRefinement) {
  tests::Table table("layer_collapse_grids", heads);
  for (const auto& [name, a] :
       {std::pair{"table 1", 1.0}, {"table 1", 2.0}, {"literature", 1.0}, {"literature", 4.0}}) {
    double last = 0.0;
    for (const int across : {6, 12, 24}) {
      const double reach = run(table, name, a, across);
      if (last > 0.0) { EXPECT_NEAR(reach / last, 1.0, 0.08) << name << " " << a << " " << across; }
      last = reach;
    }
  }
}

/// A cliff is no function of x for long: the tall column falls within its edge faster than it spreads.
TEST(LayerCollapse, AnEdgeTooSteepForAHeightFunctionEndsInANamedError) {
  EXPECT_THROW((void)collapse(literature, 3.0, 6, 1.0 / 3.0), core::IntegrationError);
}

}  // namespace
