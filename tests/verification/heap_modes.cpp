#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ida/ida.hpp"
#include "kinsol/kinsol.hpp"
#include "layer/layer.hpp"
#include "modes/leading_modes.hpp"
#include "support/example_scene.hpp"

/// The slowest mode of a heap about its steady state, against how the heap nears that state in time.
namespace {

using namespace talus;

double mass(const layer::Layer& system, std::span<const double> y) {
  double sum = 0.0;
  for (int i = 0; i < system.columns().n_columns; ++i) sum += y[system.unknowns().H(i)];
  return sum;
}

/// The heap of 30x12 cells from one time to another, from a state or from the start.
struct Stretch {
  Stretch(std::vector<std::string> settings, double from, const std::vector<double>* start, double to)
      : scene(scene_of(std::move(settings))),
        system(app::make_layer_parameters(scene)),
        integrator(system, app::make_integrator_options(scene)) {
    std::vector<double> y(system.layout().size()), yp(y);
    if (start != nullptr) y = *start;
    else system.initial_state(0.0, y, yp);
    integrator.start(from, y, yp);
    integrator.advance(to, nobody);
  }
  static app::Scene scene_of(std::vector<std::string> settings) {
    settings.insert(settings.end(), {"inflow.stop=4000", "time.end=4000"});
    return tests::small("heap_q46", 30, 12, std::move(settings));
  }
  [[nodiscard]] std::vector<double> state() const {
    const auto now = integrator.current();
    return {now.y.begin(), now.y.end()};
  }
  core::Observer nobody;
  app::Scene scene;
  layer::Layer system;
  ida::Ida integrator;
};

/// The pour needs many steps and no accuracy: what is measured begins when the heap has nearly settled.
TEST(HeapModes, TheSlowestIsThePaceAtWhichTheHeapSettles) {
  constexpr double poured = 500.0, early = 600.0, late = 900.0, settled = 2000.0;  // [s]
  const auto nearly = Stretch({"integrator.rtol=1e-3"}, 0.0, nullptr, poured).state();
  Stretch fine({"integrator.rtol=1e-7", "integrator.atol_height=1e-10", "integrator.atol_velocity=1e-8",
                "integrator.atol_pressure=1e-4"},
               poured, &nearly, early);
  const auto& system = fine.system;
  auto& stepping = fine.integrator;
  const double mass_early = mass(system, stepping.current().y);
  stepping.advance(late, fine.nobody);
  const double mass_late = mass(system, stepping.current().y);

  kinsol::Options steady_options;
  steady_options.rtol = 1e-8;
  steady_options.linear = app::make_integrator_options(fine.scene).linear;
  kinsol::Kinsol steady(system, steady_options);
  steady.start(settled, stepping.current().y, stepping.current().yp);
  steady.advance(settled, fine.nobody);
  const double limit = mass(system, steady.current().y);
  const double pace = std::log((mass_late - limit) / (mass_early - limit)) / (late - early);

  auto found = modes::leading_modes(system, settled, steady.current().y,
                                    {.shifts = {0.01}, .n_modes = 8, .n_vectors = 40, .linear = steady_options.linear});
  std::erase_if(found.modes, [](const modes::Mode& mode) { return std::abs(mode.rate) < 1e-8; });  // accumulated masses
  ASSERT_FALSE(found.modes.empty());
  const auto& slowest = found.modes.front();
  std::printf("settles at %.6g 1/s, slowest mode %.6g 1/s, the next %.6g 1/s\n", pace, slowest.rate.real(),
              found.modes.at(1).rate.real());
  EXPECT_LT(slowest.residual, 1e-10);
  EXPECT_EQ(slowest.rate.imag(), 0.0);
  EXPECT_LT(slowest.rate.real(), 0.0);
  EXPECT_NEAR(pace / slowest.rate.real(), 1.0, 0.02);
}

}  // namespace
