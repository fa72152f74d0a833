#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "app/column_model.hpp"
#include "column/layer_state.hpp"
#include "layer/layer.hpp"
#include "support/example_scene.hpp"
#include "support/random_state.hpp"

/// What the column alone can promise.
namespace {

using namespace talus;

const tests::Case chute{"column", "chute_periodic"};

/// Speeds of any sign and size, and the sum of |.| of what is summed, for rounding.
struct State {
  std::vector<double> u, rate;
  explicit State(const column::Column& system) { tests::RandomState{}.fill(system, 7, u, rate); }
};

TEST(Column, StressesBetweenLayersCancelToRounding) {
  for (const auto& settings : {std::vector<std::string>{}, {"grid.spacing=uniform"}}) {
    const column::Column system(app::make_column_parameters(chute.read(4, 40, settings)));
    const State state(system);
    std::vector<double> r(state.u.size());
    system.residual(0.1, state.u, state.rate, r);
    const auto f = column::forces(system, 0.1, state.u);
    double momentum_rate = 0.0, size = 0.0;
    for (std::size_t k = 0; k < r.size(); ++k) {
      momentum_rate +=
          system.parameters().grains.rho() * system.heights().thickness(static_cast<int>(k)) * state.rate[k];
      size += std::abs(r[k]);
    }
    const double sum = std::accumulate(r.begin(), r.end(), 0.0);
    EXPECT_NEAR(sum, momentum_rate - f.weight - f.wall_friction - f.base_stress, 1e-14 * size);
    EXPECT_NEAR(f.imbalance(), 0.0, 1e-14 * size);
    EXPECT_GT(std::abs(f.wall_friction), 0.0);
    EXPECT_GT(std::abs(f.base_stress), 0.0);
  }
}

/// The same physics on the same cells: a layer whose columns all move alike has the column's rows.
void expect_rows_of_the_layer_model(std::vector<std::string> settings) {
  settings.insert(settings.end(), {"rheology.p_0=0", "rheology.rate_speed=1e-2"});
  const auto scene = chute.read(4, 12, settings);
  const column::Column column(app::make_column_parameters(scene));
  const layer::Layer layer(app::make_layer_parameters(tests::small("chute_periodic", 4, 12, settings)));
  const State state(column);
  const auto& at = layer.unknowns();
  std::vector<double> y(layer.layout().size()), yp(y), r_layer(y), r(state.u.size());
  layer.initial_state(0.0, y, yp);  // lithostatic
  for (int f = 0; f < 4; ++f)
    for (int k = 0; k < 12; ++k) {
      y[at.u(f, k)] = state.u[k];
      yp[at.u(f, k)] = state.rate[k];
    }
  layer.residual(0.1, y, yp, r_layer);
  column.residual(0.1, state.u, state.rate, r);
  for (int k = 0; k < 12; ++k)
    EXPECT_NEAR(r_layer[at.momentum_u(1, k)], r[k], 1e-12 * (std::abs(r[k]) + 1.0)) << column.describe(k);
}

TEST(Column, RowsAreThoseOfTheLayerModelForAUniformLayer) {
  expect_rows_of_the_layer_model({});
  expect_rows_of_the_layer_model({"box.base_friction=0.3"});
  expect_rows_of_the_layer_model({"box.base_slip_length=2e-3"});
  expect_rows_of_the_layer_model({"box.base_slip_length=2e-3", "box.base_friction=0.6"});
}

TEST(Column, BaseSlopeIsAnotherWayToTilt) {
  const double lean = std::atan(0.3);
  auto scene = chute.read(4, 12);
  auto tilted = scene;
  tilted.box.base_slope = 0.3;
  tilted.box.tilt += lean;
  tilted.initial.thickness /= std::cos(lean);
  tilted.cells.cluster_depth /= std::cos(lean);
  const column::Column a(app::make_column_parameters(scene)), b(app::make_column_parameters(tilted));
  const State state(a);
  std::vector<double> r_a(12), r_b(12);
  a.residual(0.0, state.u, state.rate, r_a);
  b.residual(0.0, state.u, state.rate, r_b);
  for (int k = 0; k < 12; ++k) EXPECT_NEAR(r_a[k], r_b[k], 1e-12 * (std::abs(r_a[k]) + 1.0)) << k;
}

TEST(Column, AMirroredLayerHasTheMirroredRowsBitByBit) {
  auto scene = chute.read(4, 12, {"box.base_slope=0.1"});
  const column::Column system(app::make_column_parameters(scene));
  scene.box.tilt *= -1.0;
  scene.box.base_slope *= -1.0;
  const column::Column mirror(app::make_column_parameters(scene));
  State state(system);
  std::vector<double> r(12), r_mirror(12);
  system.residual(0.0, state.u, state.rate, r);
  for (auto* v : {&state.u, &state.rate})
    for (double& number : *v) number = -number;
  mirror.residual(0.0, state.u, state.rate, r_mirror);
  for (int k = 0; k < 12; ++k) EXPECT_EQ(r_mirror[k], -r[k]) << k;
}

}  // namespace
