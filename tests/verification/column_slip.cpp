#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "rheology/basal_slip.hpp"
#include "support/column_run.hpp"

/// A column on a base on which its grains slip by Navier's length, u_b = l du/dz: what slip adds is l times the shear rate on the base.
namespace {

using namespace talus;

struct Case {
  const char* words;
  double slope, thickness, mu_w;  ///< [degree], [m], [1]
  double slip_length;             ///< [m]
};

column::Parameters parameters(const Case& c, int layers) {
  auto par = tests::table_2(c.slope, c.thickness, layers, c.mu_w);
  par.box.base_slip_length = c.slip_length;
  par.wall.u_c = 1e-5;  // all that slip is far faster: wall friction is turned on everywhere
  return par;
}

/// The exact flow over a base to which grains stick; on one on which they slip, all move faster by slip(flow).
steady::UniformFlow sticking(const column::Parameters& par, const Case& c) {
  return *steady::UniformFlow::at(tests::steady_layer(par).channel, c.slope * tests::degree, c.thickness);
}
double shear_rate_on_base(const steady::UniformFlow& flow, const column::Parameters& par, const Case& c) {
  const double p = par.grains.rho() * 9.81 * std::cos(c.slope * tests::degree) * c.thickness;
  return flow.inertial_number(-c.thickness) * std::sqrt(p / par.grains.rho_star) / par.grains.d;
}

const Case cases[] = {{"Bagnold's flow, 26 degrees, 10 mm, l = 2 mm", 26.0, 0.01, 0.0, 0.002},
                      {"between walls, 45 degrees, 4 mm, l = 2 mm", 45.0, 0.004, 0.3727, 0.002},
                      {"between walls, 45 degrees, 4 mm, l = 20 mm", 45.0, 0.004, 0.3727, 0.02}};

TEST(SlippingColumn, IsTheExactFlowAndSlipAtOrderTwo) {
  for (const auto& c : cases) {
    std::printf("%s\nlayers  L1         Linf       slip\n", c.words);
    std::vector<double> width, L1, slip;
    for (const int layers : {25, 50, 100, 200, 400}) {
      const auto par = parameters(c, layers);
      const auto flow = sticking(par, c);
      const double gamma = shear_rate_on_base(flow, par, c), exact_slip = c.slip_length * gamma;
      tests::ColumnRun run(par, tests::precise());
      run.at(60.0);
      const auto& at = run.column().heights();
      const double scale = flow.surface_speed() + exact_slip;
      double l1 = 0.0, linf = 0.0;
      for (int k = 0; k < layers; ++k) {
        const double off = std::abs(run.u()[k] - flow.speed(at.centre[k] - at.surface()) - exact_slip) / scale;
        l1 += off * at.thickness(k) / at.surface();
        linf = std::max(linf, off);
      }
      const double slipping =
          rheology::slip_share(c.slip_length, at.distance(0)) * run.u()[0];  // the speed on the base itself
      width.push_back(1.0 / layers), L1.push_back(l1), slip.push_back(std::abs(slipping - exact_slip) / scale);
      std::printf("%6d  %.3e  %.3e  %.3e\n", layers, l1, linf, slip.back());
    }
    const double order = diagnostics::fitted_order(width, L1);
    std::printf("order   %.3f\n", order);
    EXPECT_NEAR(order, 2.0, 0.1) << c.words;
    EXPECT_LT(slip.back(), 1e-8) << c.words;
  }
}

TEST(SlippingColumn, TendsToSticking) {
  auto c = cases[1];
  const auto par = parameters(c, 100);
  const double gamma = shear_rate_on_base(sticking(par, c), par, c);
  const auto mean = [&](double l) {
    c.slip_length = l;
    tests::ColumnRun run(parameters(c, 100), tests::precise(1e-10));
    run.at(20.0);
    return run.flow() / c.thickness;
  };
  const double stuck = mean(0.0);
  for (const double l : {1e-4, 1e-5, 1e-6}) {
    const double added = (mean(l) - stuck) / (l * gamma);
    std::printf("l = %.0e m: slip adds %.5f l du/dz\n", l, added);
    EXPECT_NEAR(added, 1.0, 1e-3);
  }
}

/// A base that slips by Navier's length and bears mu_b p at most: of both stresses the smaller acts.
TEST(SlippingColumn, TheSmallerStressActs) {
  auto c = cases[2];
  const auto mean = [&](double mu_b) {
    auto par = parameters(c, 40);
    par.regularisation = {.eta_max = 1e4, .cap = rheology::Cap::smooth};
    if (mu_b > 0.0) par.box.base_friction = mu_b;
    tests::ColumnRun run(par, tests::precise());
    run.at(1.0);
    const double p = par.grains.rho() * 9.81 * std::cos(c.slope * tests::degree) * c.thickness;
    return std::pair{run.flow() / c.thickness, -column::forces(run.column(), 1.0, run.u()).base_stress / p};
  };
  const auto navier = mean(0.0), rough = mean(1e3), smooth = mean(0.2);
  EXPECT_NEAR(rough.first, navier.first, 1e-7 * navier.first);
  EXPECT_NEAR(smooth.second, 0.2, 0.01);
  EXPECT_GT(navier.second, 0.4);
  EXPECT_GT(smooth.first, 2.0 * navier.first);
}

}  // namespace
