#include "support/mode_cases.hpp"

/// Modes of the layer about its discrete steady states, from its exact Jacobian: growth rates against independent eigenproblems.
namespace {

using namespace talus;
using namespace talus::tests;

TEST(LayerModes, SimpleShearBetweenWallsGrowsAsIndependentEigenproblemsSay) {
  const json data = support::reference("stability.json");
  compare("layer_modes_couette", data.at("couette"), "k", 64, false,
          [&](const json& row, int layers) { return couette(data, row, layers); });
}

TEST(LayerModes, BagnoldsFlowUnderALidDecaysAsIndependentEigenproblemsSay) {
  const json data = support::reference("stability.json");
  compare("layer_modes_bagnold", data.at("bagnold"), "k_h", 64, false,
          [&](const json& row, int layers) { return bagnold(data, row, layers); });
}

}  // namespace
