#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ida/ida.hpp"
#include "steady/uniform_flow.hpp"
#include "support/layer_cases.hpp"
#include "support/table.hpp"

/// A pile flatter than the angle of repose: at rest under the classical law, but for the cap of its viscosity, and creeping under
/// the regularised one.
namespace {

using namespace talus;

constexpr double length = 0.3, mean = 0.1, end = 2.0;  // [m], [m], [s]

struct Creep {
  double speed;  ///< of the fastest grains [m/s]
  double fall;   ///< of the crest [m/s]
};

/// A cosine of a surface, `steepest` its largest slope, on a level base, after `end`.
Creep creep(const rheology::Law& law, double eta_max, double steepest) {
  const int columns = 24, layers = 12;
  auto par = tests::periodic_layer(length, mean, 0.0, columns, layers);
  par.law = law;
  par.regularisation = {
      .p_0 = 0.01, .rate_floor = 0.0, .rate_speed = 0.0, .eta_max = eta_max, .cap = rheology::Cap::hard};
  par.grid.cluster_depth = 0.02;
  par.atol_velocity = 1e-8;
  par.atol_height = 1e-9;
  const layer::Layer system(par);
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  const double k = 2.0 * std::numbers::pi / length;
  for (int i = 0; i < columns; ++i)
    y[system.unknowns().H(i)] += steepest / k * std::cos(k * system.columns().x_centre(i));
  ida::Ida integrator(system, {});
  integrator.start(0.0, y, yp);
  core::Observer nobody;
  integrator.advance(end, nobody);
  const auto now = integrator.current();
  Creep result{0.0, -now.yp[system.unknowns().H(0)]};
  for (int f = 0; f < columns; ++f)
    for (int l = 0; l < layers; ++l) result.speed = std::max(result.speed, std::abs(now.y[system.unknowns().u(f, l)]));
  EXPECT_EQ(now.statistics.newton_failures, 0);
  return result;
}

TEST(LayerPile, RestsUnderTheClassicalLawAndCreepsUnderTheRegularised) {
  tests::Table table("layer_pile", {"law", "steepest [degree]", "eta_max [Pa s]", "fastest [m/s]",
                                    "fall of crest [m/s]", "fastest eta_max"});
  const double degrees = 20.0,
               steepest = std::tan(degrees * std::numbers::pi / 180.0);  // of 21.8 at which it would slide
  const auto run = [&](const std::string& name, const rheology::Law& law) {
    std::vector<Creep> list;
    for (const double eta_max : {1e4, 1e5, 1e6}) {
      list.push_back(creep(law, eta_max, steepest));
      const auto& c = list.back();
      table.row({name, degrees, eta_max, c.speed, c.fall, c.speed * eta_max});
    }
    return list;
  };
  const auto rest = run("classical", tests::table_2_classical()), partial = run("partial", tests::table_2_partial());
  // What moves under the classical law is the cap alone: ten times stiffer, ten times slower.
  EXPECT_NEAR(10.0 * rest[2].speed / rest[1].speed, 1.0, 0.03);
  EXPECT_NEAR(10.0 * rest[2].fall / rest[1].fall, 1.0, 0.03);
  EXPECT_LT(rest[2].speed, 4e-6);
  EXPECT_GT(partial[2].speed, 5.0 * rest[2].speed);
}

/// A uniform layer at 18 degrees: the creep of the regularised law has an exact profile, the classical law has none.
TEST(LayerPile, AUniformLayerBelowReposeCreepsAtTheExactRate) {
  const double slope = 18.0 * std::numbers::pi / 180.0, thickness = 0.02, eta_max = 1e7;
  const auto speed = [&](const rheology::Law& law) {
    auto par = tests::periodic_layer(0.02, thickness, slope, 2, 32);
    par.law = law;
    par.regularisation.eta_max = eta_max;
    par.regularisation.cap = rheology::Cap::hard;
    par.atol_velocity = 1e-9;
    const layer::Layer system(par);
    std::vector<double> y(system.layout().size()), yp(y);
    system.initial_state(0.0, y, yp);
    ida::Ida integrator(system);
    integrator.start(0.0, y, yp);
    core::Observer nobody;
    integrator.advance(10.0, nobody);
    const auto now = integrator.current();
    const auto& context = system.context(now.t, now.y);
    const double z = 0.5 * (context.z[context.at(0, 31)] + context.z[context.at(0, 32)]) - thickness;
    return std::pair{z, now.y[system.unknowns().u(0, 31)]};
  };
  const auto [z, creeping] = speed(tests::table_2_partial());
  const auto resting = speed(tests::table_2_classical()).second;
  const steady::Channel channel{tests::table_2_grains(), tests::table_2_partial(), 0.003, 0.0, 9.81};
  const double exact = steady::UniformFlow::at(channel, slope, thickness)->speed(z);
  const double capped =
      tests::table_2_grains().rho() * 9.81 * std::sin(slope) * (thickness * thickness - z * z) / (2.0 * eta_max);
  std::printf("speed in the top layer: regularised %.4e m/s, exact %.4e; classical %.4e, of the cap %.4e\n", creeping,
              exact, resting, capped);
  EXPECT_NEAR(creeping / exact, 1.0, 0.01);
  EXPECT_NEAR(resting / capped, 1.0, 0.01);
}

}  // namespace
