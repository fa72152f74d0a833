#pragma once

#include <string>
#include <vector>

#include "app/two_fluid_model.hpp"
#include "support/example_scene.hpp"
#include "support/random_state.hpp"
#include "two_fluid/two_fluid.hpp"

namespace talus::tests {

using Settings = std::vector<std::string>;

/// The heap of 4.6 g/s as grains and air, with further settings "key=value".
inline two_fluid::Parameters heap_of_two_fluids(int columns, int layers, Settings settings = {}) {
  return app::make_two_fluid_parameters(Case{"two_fluid", "heap_q46"}.read(columns, layers, std::move(settings)));
}

/// A random state of that model, and its residual.
struct TwoFluidState {
  std::vector<double> y, yp, r;
  TwoFluidState(const two_fluid::TwoFluid& system, unsigned seed, double speed = 0.3) : r(system.layout().size()) {
    RandomState{speed}.fill(system, seed, y, yp);
    system.residual(0.1, y, yp, r);
  }
};

}  // namespace talus::tests
