#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/triangle_model.hpp"
#include "core/errors.hpp"
#include "steady/uniform_flow.hpp"
#include "support/example_scene.hpp"
#include "triangle/fields.hpp"
#include "triangle/triangle.hpp"

/// What the triangle alone can promise.
namespace {

using namespace talus;
using triangle::Triangle;

Triangle heap(int columns, const std::vector<std::string>& settings = {}) {
  return Triangle(app::make_triangle_parameters(tests::Case{"triangle", "heap_q46"}.read(columns, 5, settings)));
}

TEST(Triangle, WhatIsPouredIsInTheHeapOrOverTheEnd) {
  const auto system = heap(9);
  for (const double mass : {0.0, 1e-3, 0.05, 0.15}) {
    const std::vector<double> y{mass, 0.3, 0.2}, rate{0.7, -0.4, 0.1};
    std::vector<double> r(3);
    system.residual(1.0, y, rate, r);
    EXPECT_NEAR(r[Triangle::mass] - r[Triangle::mass_in] + r[Triangle::mass_right],
                rate[Triangle::mass] - rate[Triangle::mass_in] + rate[Triangle::mass_right], 1e-15)
        << mass << " kg";
  }
}

/// Also where the left face meets the end of the box, and what lies beyond it has left.
TEST(Triangle, TheSurfaceHoldsTheStoredMass) {
  const auto system = heap(4000, {"model.left_slope=5"});
  triangle::TriangleFields fields(system);
  const auto variables = fields.variables();
  std::vector<std::vector<double>> values;
  bool cut = false;
  for (const double mass : {1e-3, 0.05, 0.15, 0.2}) {
    const std::vector<double> y{mass, 0.0, 0.0}, rate{0.1, 0.0, 0.0};
    fields.evaluate({1.0, y, rate, core::Statistics{}}, values);
    const auto of = [&](const char* name) -> const std::vector<double>& {
      return values.at(std::ranges::find(variables, name, &core::Variable::name) - variables.begin());
    };
    const auto& H = of("height");
    const double area = std::accumulate(H.begin(), H.end(), 0.0) * system.parameters().box.length / 4000;
    EXPECT_NEAR(area * system.mass_per_area(), of("mass_stored")[0], 1e-5 * mass) << mass << " kg";
    EXPECT_NEAR(of("mass_stored")[0] + of("mass_outflow_left")[0], mass, 1e-15);
    EXPECT_EQ(of("outflow_rate_left")[0] > 0.0, of("mass_outflow_left")[0] > 0.0);
    cut |= of("mass_outflow_left")[0] > 0.0;
  }
  EXPECT_TRUE(cut);
}

/// Where half its height is less than the depth that would flow, the base bounds the flow.
TEST(Triangle, AThinHeapFlowsOverItsBase) {
  const auto system = heap(9);
  const auto& par = system.parameters();
  for (const double mass : {1e-4, 1e-3, 5e-3}) {
    const auto shape = system.shape(mass);
    const double lean = std::atan(shape.rise);
    const auto flow = steady::UniformFlow::at(par.channel, par.box.tilt + lean, 0.5 * shape.apex_z * std::cos(lean));
    ASSERT_TRUE(flow && flow->on_base()) << mass << " kg";
    EXPECT_NEAR(system.context(1.0, mass).outflow, flow->flux(), 1e-9 * flow->flux()) << mass << " kg";
  }
}

/// The classical law holds what is no steeper than mu_s, and has no steady flow from mu_d on.
TEST(Triangle, FlowsBetweenReposeAndTheLargestFriction) {
  const auto system = heap(9, {"rheology.law=classical", "box.tilt=20"});
  EXPECT_EQ(system.context(1.0, 1e-3).outflow, 0.0);
  EXPECT_GT(system.context(1.0, 0.05).outflow, 0.0);
  EXPECT_THROW((void)system.context(1.0, 0.3), core::InadmissibleState);
}

}  // namespace
