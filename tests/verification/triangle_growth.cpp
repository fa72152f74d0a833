#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "app/triangle_model.hpp"
#include "support/example_scene.hpp"
#include "triangle/outflow.hpp"
#include "triangle/triangle.hpp"

/// The triangle against an independent integration of the same reduced equation (triangle_heap.json, mode "toe": flux of the
/// exact steady flow without a base), for the heap of Q = 0.0046 kg/s from the 0.065 kg that the paper prints at 16.8 s.
namespace {

using namespace talus;

constexpr double degree = std::numbers::pi / 180.0;

triangle::Triangle heap(double left_slope) {
  auto par = app::make_triangle_parameters(app::read_scene(tests::example("heap_q46"), {"model.name=triangle"}));
  par.left_slope = left_slope * degree;
  return triangle::Triangle(par);
}

/// Mass [kg] at time `to` from `mass` at time `from`, by the classical Runge-Kutta formula in steps of 0.05 s.
double grown(const triangle::Triangle& model, double from, double to, double mass) {
  const auto rate = [&](double m) {
    const auto c = model.context(from, m);
    return c.inflow - c.outflow;
  };
  const int n = static_cast<int>(std::lround((to - from) / 0.05));
  const double h = (to - from) / n;
  for (int i = 0; i < n; ++i) {
    const double a = rate(mass), b = rate(mass + 0.5 * h * a), c = rate(mass + 0.5 * h * b), d = rate(mass + h * c);
    mass += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return mass;
}

struct Reference {
  double left_slope;  ///< [degree]
  std::array<double, 5> mass;
};

TEST(TriangleGrowth, FollowsAnIndependentIntegration) {
  constexpr std::array times{30.8, 56.0, 80.0, 106.0, 150.0};
  for (const auto& [left_slope, expected] : {Reference{22.0,
                                                       {0.10818268405189707, 0.14794006610812627, 0.16095408652456944,
                                                        0.16534464157082085, 0.1668868325334218}},
                                             Reference{27.0,
                                                       {0.10730424196993421, 0.14461846940395753, 0.1560028134544271,
                                                        0.15957819877485035, 0.16073033077767399}}}) {
    const auto model = heap(left_slope);
    double t = 16.8, mass = 0.065;
    for (std::size_t i = 0; i < times.size(); ++i) {
      mass = grown(model, t, times[i], mass);
      t = times[i];
      EXPECT_NEAR(mass, expected[i], 1e-5 * expected[i]) << left_slope << " degrees, " << t << " s";
    }
  }
}

TEST(TriangleOutflow, DerivativesAreThoseOfTheFlux) {
  const auto channel = heap(22.0).parameters().channel;
  for (const double tan_zeta : {0.3, 0.6, 1.0, 1.2})
    for (const double h : {1e-3, 4e-3, 0.1}) {
      const auto at = triangle::outflow(channel, tan_zeta, h);
      const double e = 1e-5;
      const auto difference = [&](double dT, double dh) {
        return triangle::outflow(channel, tan_zeta + dT, h + dh).rate -
               triangle::outflow(channel, tan_zeta - dT, h - dh).rate;
      };
      EXPECT_NEAR(at.by_tangent * 2.0 * e * tan_zeta, difference(e * tan_zeta, 0.0),
                  1e-7 * at.by_tangent * e * tan_zeta + 1e-13 * at.rate)
          << tan_zeta << ", " << h;
      EXPECT_NEAR(at.by_thickness * 2.0 * e * h, difference(0.0, e * h),
                  1e-6 * at.by_thickness * e * h + 1e-12 * at.rate)
          << tan_zeta << ", " << h;
    }
}

}  // namespace
