#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ida/ida.hpp"
#include "support/layer_cases.hpp"
#include "support/table.hpp"

/// A heap begins to grow on a film of grains of thickness Hs: what its answer and its cost owe to Hs, which is no physics.
namespace {

using namespace talus;

layer::Parameters pour(double film) {
  auto par = tests::periodic_layer(0.6, film, 29.2 * std::numbers::pi / 180.0, 60, 12);
  par.box.periodic = false;
  par.box.height = 0.3;
  par.wall = {.mu_w = 0.3727, .u_c = 5e-4};
  par.inflow = {.rate = 0.0046, .position = 0.11, .width = 0.008};
  par.regularisation = {.p_0 = 0.01, .rate_floor = 0.0, .rate_speed = 1e-2, .eta_max = 1e3, .cap = rheology::Cap::hard};
  par.grid.cluster_depth = 0.003;
  par.numerics.film = film;
  return par;
}

struct Heap {
  double stored, front, highest;  ///< [kg] beyond the film; [m] where the last grains lie 2 mm deep; [m]
};

TEST(LayerFilm, AnswerAndCostBarelyChangeAsTheFilmThins) {
  tests::Table table(
      "layer_film", {"film [m]", "stored [kg]", "front [m]", "highest [m]", "steps", "Newton fails", "factorisations"});
  std::vector<Heap> heaps;
  std::vector<double> steps;
  for (const double film : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const layer::Layer system(pour(film));
    const auto& par = system.parameters();
    const auto& c = system.columns();
    std::vector<double> y(system.layout().size()), yp(y);
    system.initial_state(0.0, y, yp);
    ida::Ida integrator(system);
    core::Observer nobody;
    integrator.start(0.0, y, yp);
    integrator.advance(6.0, nobody);
    const auto now = integrator.current();
    Heap heap{0.0, 0.0, 0.0};
    for (int i = 0; i < c.n_columns; ++i) {
      const double H = now.y[system.unknowns().H(i)];
      heap.stored += (H - film) * c.dx() * par.grains.rho() * par.box.gap;
      if (H > film + 2e-3) heap.front = c.x_centre(i);
      heap.highest = std::max(heap.highest, H);
    }
    const auto& s = now.statistics;
    table.row({film, heap.stored, heap.front, heap.highest, double(s.steps), double(s.newton_failures),
               double(s.factorisations)});
    EXPECT_EQ(s.newton_failures, 0) << film;
    heaps.push_back(heap);
    steps.push_back(double(s.steps));
  }
  EXPECT_NEAR(heaps[2].highest / heaps[3].highest, 1.0, 1e-3);
  EXPECT_NEAR(heaps[2].stored / heaps[3].stored, 1.0, 1e-3);
  EXPECT_NEAR(heaps[0].highest / heaps[3].highest, 1.0, 0.04);
  EXPECT_NEAR(heaps[0].stored / heaps[3].stored, 1.0, 2e-3);
  EXPECT_LT(steps[3], 1.5 * steps[0]);
}

}  // namespace
