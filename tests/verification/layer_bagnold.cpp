#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "diagnostics/norms.hpp"
#include "diagnostics/observed_order.hpp"
#include "ida/ida.hpp"
#include "steady/uniform_flow.hpp"
#include "support/layer_cases.hpp"
#include "support/reference.hpp"
#include "support/table.hpp"

/// Bagnold's flow in two dimensions, from rest: its steady profile, and its start with and without walls.
namespace {

using namespace talus;

/// Errors of u in the Bagnold test of the Gerris flow solver (P.-Y. Lagree), for N = 8, 16, 32, 64 cells over the depth. Whether
/// they are shares of u is not known; taken in units of sqrt(g H) they are the harder mark, as u reaches 2.07 of these.
struct Published {
  int layers;
  double l1, l2, linf;
};
const std::vector<Published> published{{8, 3.6e-2, 3.9e-2, 5.2e-2},
                                       {16, 1.16e-2, 1.22e-2, 1.44e-2},
                                       {32, 3.3e-3, 3.4e-3, 5.8e-3},
                                       {64, 8.7e-4, 9.0e-4, 2.4e-3}};

/// Unit depth, gravity and density: speeds are in units of sqrt(g H).
layer::Parameters unit_layer(int layers) {
  auto par = tests::periodic_layer(1.0, 1.0, 0.43, 2, layers);
  par.box.gravity = 1.0;
  par.grains = rheology::grains(1.0, 1.0, 0.04);
  par.law = rheology::classical(0.38, 0.38 + 0.26, 0.3);
  par.regularisation.eta_max = 1e3;
  par.regularisation.cap = rheology::Cap::hard;
  par.atol_velocity = 1e-8;
  par.atol_pressure = 1e-6;
  par.atol_height = 1e-9;
  return par;
}

TEST(LayerBagnold, SteadyProfileIsBetterThanThePublishedOneAtEveryLevel) {
  tests::Table table("layer_bagnold", {"layers", "L1", "L2", "Linf", "L1 published", "L2 published", "Linf published"});
  std::vector<double> h, l1, l2, linf;
  for (const auto& other : published) {
    const auto par = unit_layer(other.layers);
    const layer::Layer system(par);
    const steady::Channel channel{par.grains, par.law, par.box.gap, 0.0, par.box.gravity};
    const auto exact = steady::UniformFlow::at(channel, par.box.tilt, 1.0);
    std::vector<double> y(system.layout().size()), yp(y);
    system.initial_state(0.0, y, yp);
    ida::Options options;
    options.rtol = 1e-6;
    ida::Ida integrator(system, options);
    integrator.start(0.0, y, yp);
    core::Observer nobody;
    integrator.advance(1e4, nobody);
    const auto now = integrator.current();
    const auto& context = system.context(now.t, now.y);
    std::vector<double> error;
    for (int k = 0; k < other.layers; ++k) {
      const double z = 0.5 * (context.z[context.at(0, k)] + context.z[context.at(0, k + 1)]) - 1.0;
      error.push_back(now.y[system.unknowns().u(0, k)] - exact->speed(z));
    }
    const auto e = diagnostics::norms(error);
    table.row({double(other.layers), e.l1, e.l2, e.linf, other.l1, other.l2, other.linf});
    EXPECT_LT(e.l1, other.l1) << other.layers;
    EXPECT_LT(e.l2, other.l2) << other.layers;
    EXPECT_LT(e.linf, other.linf) << other.layers;
    h.push_back(1.0 / other.layers);
    l1.push_back(e.l1);
    l2.push_back(e.l2);
    linf.push_back(e.linf);
  }
  EXPECT_NEAR(diagnostics::fitted_order(h, l1), 2.0, 0.1);
  EXPECT_NEAR(diagnostics::fitted_order(h, l2), 2.0, 0.1);
  EXPECT_GT(diagnostics::fitted_order(h, linf), 1.45);  // u grows as the depth to 3/2 under the surface
}

/// The flux [m2/s] of a layer at the times of a reference case, with columns that lean by `lean` [rad] from the layer's normal.
std::vector<double> fluxes(const nlohmann::json& reference, int layers, double lean) {
  const auto& known = reference.at("parameters");
  const double slope = reference.at("slope").get<double>() * std::numbers::pi / 180.0;
  const double thickness = reference.at("thickness").get<double>() / std::cos(lean);
  auto par = tests::periodic_layer(0.02, thickness, slope - lean, 4, layers);
  par.box.base_slope = -std::tan(lean);
  par.box.gap = known.at("W");
  par.grains = support::grains_of(known);
  par.law = support::partial_of(known);
  par.regularisation.eta_max = reference.at("eta_max");
  par.regularisation.cap = rheology::Cap::hard;
  par.wall = {.mu_w = known.at("mu_w"), .u_c = reference.at("u_c")};
  par.atol_velocity = 1e-7;
  par.atol_pressure = 1e-3;
  par.atol_height = 1e-9;
  const layer::Layer system(par);
  std::vector<double> y(system.layout().size()), yp(y), result;
  system.initial_state(0.0, y, yp);
  ida::Options options;
  options.rtol = 1e-7;
  ida::Ida integrator(system, options);
  integrator.start(0.0, y, yp);
  core::Observer nobody;
  for (const double t : reference.at("t")) {
    integrator.advance(t, nobody);
    const auto now = integrator.current();
    const auto& context = system.context(now.t, now.y);
    double flux = 0.0;
    for (int k = 0; k < layers; ++k)
      flux += now.y[system.unknowns().u(1, k)] * (context.z[context.at(1, k + 1)] - context.z[context.at(1, k)]);
    result.push_back(flux);
  }
  return result;
}

TEST(LayerBagnold, StartFromRestFollowsTheColumn) {
  tests::Table table("layer_startup", {"case", "layers", "t [s]", "flux [m2/s]", "reference", "error"});
  const auto cases = support::reference("startup.json").at("cases");
  ASSERT_EQ(cases.size(), 2U);
  for (const auto& reference : cases) {
    const std::string name = reference.at("name");
    const std::vector<double> exact = reference.at("flux"), times = reference.at("t");
    std::vector<double> h, worst;
    for (const int layers : {16, 32, 64}) {
      const auto found = fluxes(reference, layers, 0.0);
      h.push_back(1.0 / layers);
      worst.push_back(0.0);
      for (std::size_t i = 0; i < times.size(); ++i) {
        const double error = found[i] / exact[i] - 1.0;
        worst.back() = std::max(worst.back(), std::abs(error));
        table.row({name, double(layers), times[i], found[i], exact[i], error});
      }
    }
    std::printf("order of the worst: %.2f\n", diagnostics::fitted_order(h, worst));
    EXPECT_GT(diagnostics::fitted_order(h, worst), 1.7) << name;
    EXPECT_LT(worst.back(), 2e-3) << name;
  }
}

TEST(LayerBagnold, ALeaningGridStartsTheSame) {
  const auto reference = support::reference("startup.json").at("cases").at(1);
  const auto aligned = fluxes(reference, 16, 0.0), leaning = fluxes(reference, 16, 0.35);
  for (std::size_t i = 0; i < aligned.size(); ++i) EXPECT_NEAR(leaning[i] / aligned[i], 1.0, 1e-5) << i;
}

}  // namespace
