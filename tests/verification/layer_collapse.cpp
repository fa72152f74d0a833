#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

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

/// The standing column under its own weight. Its edge is smooth over a third of its half width, two columns of the coarsest grid.
std::vector<double> standing(const layer::Layer& system, double a) {
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  const auto& c = system.columns();
  const auto& at = system.unknowns();
  for (int i = 0; i < c.n_columns; ++i) {
    const double s = std::clamp(0.5 + (half_width - c.x_centre(i)) / (half_width / 3.0), 0.0, 1.0);
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
RunOut collapse(const rheology::Law& law, double a, int across) {
  const layer::Layer system(box(law, a, across));
  const auto y = standing(system, a);
  ida::Ida integrator(system);
  core::Observer nobody;
  integrator.start(0.0, y, std::vector<double>(y.size(), 0.0));
  integrator.advance(6.0 * std::sqrt(a * half_width / system.parameters().box.gravity), nobody);
  const auto now = integrator.current();
  return {front(system, now.y, 2.0 * film) / half_width - 1.0, now.y[system.unknowns().H(0)] / half_width,
          static_cast<long>(now.statistics.steps), static_cast<long>(now.statistics.newton_failures)};
}

/// Published run-outs up to a = 7, and continuum models of the law below, grow as this.
double published(double a) { return 2.2 * a; }

TEST(LayerCollapse, RunOutAgainstAspectRatioOnThreeGrids) {
  tests::Table table("layer_collapse",
                     {"law", "a", "columns a half width", "run-out", "2.2 a", "height", "steps", "Newton fails"});
  const rheology::Law table_1 =
      rheology::partially_regularised(rheology::classical(0.342, 0.557, 0.069), 0.05, 1.9, 0.004);
  const rheology::Law literature = rheology::classical(0.32, 0.60, 0.40);
  for (const auto& [name, law] : {std::pair{"table 1", table_1}, std::pair{"literature", literature}}) {
    for (const double a : {0.5, 1.0, 2.0}) {
      double last = 0.0;
      for (const int across : {6, 12, 24}) {
        const auto r = collapse(law, a, across);
        table.row(
            {name, a, double(across), r.reach, published(a), r.height, double(r.steps), double(r.newton_failures)});
        if (across > 6) EXPECT_NEAR(r.reach / last, 1.0, 0.08) << name << " " << a << " " << across;
        last = r.reach;
      }
      if (law.index() == literature.index()) EXPECT_NEAR(last / published(a), 1.0, 0.25) << a;
      EXPECT_LT(last, 1.25 * published(a)) << name << " " << a;
    }
  }
}

}  // namespace
