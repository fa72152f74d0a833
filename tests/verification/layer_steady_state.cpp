#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ida/ida.hpp"
#include "kinsol/kinsol.hpp"
#include "layer/layer.hpp"
#include "support/example_scene.hpp"

/// The heap under a steady inflow, found directly and by waiting: index 2, moving surface, accumulators.
namespace {

using namespace talus;

TEST(LayerSteadyState, NewtonOnAGrowingHeapLeadsWhereTimeDoes) {
  const auto scene = tests::small("heap_q46", 30, 12, {"inflow.stop=2000", "time.end=2000"});
  const layer::Layer system(app::make_layer_parameters(scene));
  const auto& layout = system.layout();
  const auto stepping_options = app::make_integrator_options(scene);
  core::Observer nobody;
  std::vector<double> y(layout.size()), yp(y);
  system.initial_state(0.0, y, yp);
  ida::Ida stepping(system, stepping_options);
  stepping.start(0.0, y, yp);
  stepping.advance(149.0, nobody);  // grown to four fifths

  kinsol::Options options;
  options.linear = stepping_options.linear;
  kinsol::Kinsol direct(system, options);
  direct.start(1500.0, stepping.current().y, stepping.current().yp);
  direct.advance(1500.0, nobody);
  stepping.advance(1500.0, nobody);

  const auto found = direct.current().y, waited_for = stepping.current().y;
  for (core::Index i = 0; i < layout.size(); ++i) {
    const auto& field = layout.field(i);
    const double scale = std::abs(found[i]) + field.absolute_tolerance / stepping_options.rtol;
    if (field.unit == "kg") continue;  // what was poured in and went out
    EXPECT_NEAR(found[i], waited_for[i], 1e-4 * scale) << system.describe(i);
  }
  EXPECT_GT(direct.current().statistics.restarts, 0) << "the guess is no guess";
}

}  // namespace
