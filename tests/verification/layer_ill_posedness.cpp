#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ida/ida.hpp"
#include "layer/fields.hpp"
#include "layer/layer.hpp"
#include "steady/uniform_flow.hpp"
#include "support/example_scene.hpp"

/// How much of a steady layer between rough walls is ill-posed, against the exact profile of the inertial number. Law of table 2: C > 0
/// above I = 1.0297, waves grow above I = 1.7495.
namespace {

using namespace talus;

struct Shares {
  double ill_posed, growing;
};

Shares steady_shares(const app::Scene& scene) {
  const layer::Layer system(app::make_layer_parameters(scene));
  layer::LayerFields fields(system);
  core::Observer nobody;
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  ida::Ida integrator(system, app::make_integrator_options(scene));
  integrator.start(0.0, y, yp);
  integrator.advance(1000.0, nobody);
  std::vector<std::vector<double>> values;
  fields.evaluate(integrator.current(), values);
  const auto variables = fields.variables();
  const auto number = [&](const char* name) {
    return values.at(std::ranges::find(variables, name, &core::Variable::name) - variables.begin()).at(0);
  };
  return {number("ill_posed_share"), number("growing_share")};
}

/// The part of the depth faster than 1 % of the surface in which I exceeds a bound.
double exact_share(const steady::UniformFlow& flow, double bound) {
  const double depth = flow.depth_at_share(0.01);
  constexpr int n = 100000;
  int above = 0;
  for (int i = 0; i < n; ++i) above += flow.inertial_number(-depth * (i + 0.5) / n) > bound ? 1 : 0;
  return static_cast<double>(above) / n;
}

class IllPosedLayer : public testing::TestWithParam<double> {};

TEST_P(IllPosedLayer, HasTheSharesOfTheExactProfile) {
  const double tilt = GetParam();
  const auto scene = tests::small("chute_periodic", 4, 96,
                                  {"wall.u_c=1e-4", "rheology.p_0=0", "rheology.eta_max=1e6",
                                   "integrator.linear_solver=klu", "box.tilt=" + std::to_string(tilt)});
  const auto par = app::make_layer_parameters(scene);
  const auto flow = steady::UniformFlow::at({par.grains, par.law, par.box.gap, par.wall.mu_w, par.box.gravity},
                                            par.box.tilt, par.initial.thickness);
  const Shares found = steady_shares(scene), exact{exact_share(*flow, 1.0297), exact_share(*flow, 1.7495)};
  std::printf("tilt %g: C > 0 in %.4f, exact %.4f; growing in %.4f, exact %.4f\n", tilt, found.ill_posed,
              exact.ill_posed, found.growing, exact.growing);
  EXPECT_NEAR(found.ill_posed, exact.ill_posed, 0.02);
  EXPECT_NEAR(found.growing, exact.growing, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Layer, IllPosedLayer, testing::Values(48.0, 54.0, 66.0));

}  // namespace
