#include <gtest/gtest.h>

#include <tuple>

#include "support/column_run.hpp"

/// A layer starts from rest where rest is stiff: a viscosity cap far above what flows, wall friction that turns on below the
/// tolerance of a step, a pressure smoothed so strongly that the surface is a plug. Each start must succeed without a
/// failure of Newton's method and with few factorisations, and end in the steady profile of rung 0.
namespace {

using namespace talus;
using tests::degree;

struct Rest {
  double eta_max, u_c, p_0;
};
void PrintTo(const Rest& rest, std::ostream* out) {
  *out << "eta_max = " << rest.eta_max << " Pa s, u_c = " << rest.u_c << " m/s, p_0 = " << rest.p_0 << " Pa";
}

class FromRest : public testing::TestWithParam<std::tuple<Rest, int>> {};

TEST_P(FromRest, StartsWithoutNewtonFailuresAndEndsInTheSteadyProfile) {
  const auto& [rest, layers] = GetParam();
  auto par = tests::table_2(45.0, 0.012, layers);
  par.regularisation = {.p_0 = rest.p_0, .eta_max = rest.eta_max, .cap = rheology::Cap::smooth};
  par.wall.u_c = rest.u_c;
  par.atol_velocity = 1e-6;
  tests::ColumnRun run(par, tests::precise(1e-4));
  run.at(20.0);
  EXPECT_EQ(run.statistics().newton_failures, 0);
  EXPECT_LE(run.statistics().factorisations, 250);
  EXPECT_LE(run.statistics().steps, 250);

  const auto exact = steady::RegularisedProfile::at(tests::steady_layer(par), 45.0 * degree);
  ASSERT_TRUE(exact);
  const double flow = exact->flux() / (par.grains.rho() * par.box.gap);
  EXPECT_NEAR(run.flow() / flow, 1.0, 20.0 / (layers * layers) + 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Column, FromRest,
                         testing::Combine(testing::Values(Rest{1e8, 1e-6, 0.0}, Rest{1e10, 1e-5, 0.0},
                                                          Rest{1e4, 1e-3, 1.0}, Rest{1e4, 1e-3, 10.0},
                                                          Rest{1e8, 1e-4, 1.0}),
                                          testing::Values(50, 200, 800)));

}  // namespace
