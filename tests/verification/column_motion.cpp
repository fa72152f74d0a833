#include <gtest/gtest.h>

#include <cstdio>

#include "support/column_run.hpp"
#include "support/reference.hpp"

/// The column on its way: a Newtonian film from rest, and a box that moves.
namespace {

using namespace talus;
using tests::degree;

/// A hard cap that acts everywhere makes a Newtonian film of viscosity eta_max.
column::Parameters newtonian(const nlohmann::json& film, int layers) {
  const double rho = 1500.0;
  auto par = tests::table_2(45.0, film.at("thickness"), layers, 0.0);
  par.box.gravity = film.at("g_sin_zeta").get<double>() / std::sin(par.box.tilt);
  par.law = rheology::Constant{10.0};
  par.regularisation = {.eta_max = rho * film.at("nu").get<double>(), .cap = rheology::Cap::hard};
  return par;
}

TEST(MovingColumn, ANewtonianFilmStartsAsItsSeriesSays) {
  const auto film = support::reference("newtonian_film.json");
  tests::ColumnRun coarse(newtonian(film, 100), tests::precise(1e-9)), fine(newtonian(film, 200), tests::precise(1e-9));
  double off_coarse = 0.0, off_fine = 0.0;
  for (const auto& sample : film.at("samples")) {
    const double t = sample.at("t"), depth = -sample.at("z").get<double>(), expected = sample.at("u");
    coarse.at(t);
    fine.at(t);
    const double u_coarse = coarse.speed(depth), u_fine = fine.speed(depth);
    EXPECT_NEAR(u_fine, expected, 1.5e-4 * 50.0) << t << " s, " << depth << " m";
    if (depth == 0.0) continue;  // the surface is extrapolated as for a granular flow
    EXPECT_NEAR(u_fine + (u_fine - u_coarse) / 3.0, expected, 2e-6 * expected) << t << " s, " << depth << " m";
    off_coarse = std::max(off_coarse, std::abs(u_coarse - expected));
    off_fine = std::max(off_fine, std::abs(u_fine - expected));
  }
  EXPECT_NEAR(std::log2(off_coarse / off_fine), 2.0, 0.05);
}

TEST(MovingColumn, AStartFromRestCostsTheSameUnderAnyCap) {
  const auto steps = [](double eta_max, rheology::Cap cap) {
    auto par = tests::table_2(45.0, 0.012, 200);
    par.regularisation = {.eta_max = eta_max, .cap = cap};
    par.atol_velocity = 1e-6;
    tests::ColumnRun run(par, tests::precise(1e-4));
    run.at(2.0);
    const auto& s = run.statistics();
    std::printf("eta_max = %.0e Pa s: %lld steps, %lld failures of Newton, %lld factorisations\n", eta_max,
                static_cast<long long>(s.steps), static_cast<long long>(s.newton_failures),
                static_cast<long long>(s.factorisations));
    return static_cast<double>(s.steps);
  };
  for (const auto cap : {rheology::Cap::smooth, rheology::Cap::hard}) {
    const double at_1e4 = steps(1e4, cap);
    for (const double eta_max : {1e6, 1e8, 1e10, 1e12}) EXPECT_LT(steps(eta_max, cap), 1.25 * at_1e4);
  }
}

TEST(MovingColumn, WithoutFrictionItFallsAsTheBoxIsTurned) {
  auto par = tests::table_2(10.0, 0.01, 8, 0.0);
  par.law = rheology::Constant{0.0};
  par.motion.tilt = {{0.5, 1.5, 2.0}, {10.0 * degree, 50.0 * degree, -20.0 * degree}};
  tests::ColumnRun run(par, tests::precise(1e-9));
  const auto gained = [&](double from, double to, double seconds) {
    return from == to
               ? par.box.gravity * std::sin(from * degree) * seconds
               : par.box.gravity * (std::cos(from * degree) - std::cos(to * degree)) * seconds / ((to - from) * degree);
  };
  const double at_1 = gained(10, 10, 0.5) + gained(10, 30, 0.5);
  const double at_3 = gained(10, 10, 0.5) + gained(10, 50, 1.0) + gained(50, -20, 0.5) + gained(-20, -20, 1.0);
  for (const double u : run.at(1.0)) EXPECT_NEAR(u, at_1, 1e-6 * at_1);
  for (const double u : run.at(3.0)) EXPECT_NEAR(u, at_3, 1e-6 * at_1);
  EXPECT_EQ(run.statistics().restarts, 3);  // one a kink
}

TEST(MovingColumn, TurnedAndOpenedItEndsInTheSteadyFlowOfTheLastSlopeAndGap) {
  auto moved = tests::table_2(45.0, 0.012, 100), there = tests::table_2(40.0, 0.012, 100);
  moved.motion = {{{0.1, 0.5}, {45.0 * degree, 40.0 * degree}}, {{0.2, 0.3}, {0.003, 0.004}}};
  moved.start = tests::steady_start(moved, 45.0);
  there.box.gap = 0.004;
  there.start = tests::steady_start(there, 40.0);
  tests::ColumnRun a(moved, tests::precise()), b(there, tests::precise());
  a.at(30.0);
  b.at(30.0);
  EXPECT_NEAR(a.flow() / b.flow(), 1.0, 1e-6);
  EXPECT_NEAR(a.surface_speed() / b.surface_speed(), 1.0, 1e-6);
}

}  // namespace
