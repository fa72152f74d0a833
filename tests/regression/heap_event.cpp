#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ida/ida.hpp"
#include "layer/fields.hpp"
#include "layer/layer.hpp"
#include "support/example_scene.hpp"

/// The whole event on a coarse grid, from an empty box through heap, shut-off and drain, at each inflow of the paper.
namespace {

using namespace talus;

class WholeEvent : public testing::TestWithParam<const char*> {};

/// Watches what must hold at every step.
class Watch : public core::Observer {
 public:
  explicit Watch(const layer::Layer& layer) : layer_(layer) {}
  bool on_step(const core::Snapshot& now) override {
    for (int i = 0; i < layer_.columns().n_columns; ++i) least_H = std::min(least_H, now.y[layer_.unknowns().H(i)]);
    return true;
  }
  double least_H = 1.0;

 private:
  const layer::Layer& layer_;
};

TEST_P(WholeEvent, RunsToTheEndAndLosesNoMass) {
  const auto scene = tests::small(GetParam(), 60, 16);
  const layer::Layer system(app::make_layer_parameters(scene));
  layer::LayerFields fields(system);
  ida::Ida integrator(system, app::make_integrator_options(scene));
  Watch watch(system);
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  integrator.start(0.0, y, yp);

  const auto variables = fields.variables();
  std::vector<std::vector<double>> values;
  const auto number = [&](const char* name) {
    const auto found = std::ranges::find(variables, name, &core::Variable::name);
    return values.at(found - variables.begin()).at(0);
  };
  integrator.advance(system.parameters().inflow.stop, watch);
  fields.evaluate(integrator.current(), values);
  const double full = number("mass_stored"), slope = number("heap_angle"), poured = number("mass_inflow");
  EXPECT_LT(std::abs(number("mass_error")), 1e-10 * poured);
  EXPECT_GT(slope, 43.0);
  EXPECT_GT(number("outflow_rate_right"), 0.9 * system.parameters().inflow.rate);

  integrator.advance(scene.end, watch);
  fields.evaluate(integrator.current(), values);
  EXPECT_LT(std::abs(number("mass_error")), 1e-10 * poured);
  EXPECT_NEAR(number("mass_inflow"), poured + 0.5 * system.parameters().inflow.ramp * system.parameters().inflow.rate,
              1e-4 * poured);
  EXPECT_LT(number("mass_stored"), 0.75 * full);
  EXPECT_LT(number("heap_angle"), slope);
  EXPECT_NEAR(number("mass_outflow_left"), 0.0, 1e-12);
  EXPECT_GE(watch.least_H, system.parameters().numerics.film * (1.0 - 1e-3));
  EXPECT_LE(integrator.current().statistics.newton_failures, 5);
}

INSTANTIATE_TEST_SUITE_P(Layer, WholeEvent, testing::Values("heap_q20", "heap_q46", "heap_q60"));

}  // namespace
