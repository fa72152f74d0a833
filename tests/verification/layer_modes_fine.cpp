#include "support/mode_cases.hpp"

/// As layer_modes, of waves that lean so narrowly that they need 256 layers.
namespace {

using namespace talus;
using namespace talus::tests;

TEST(LayerModesFine, SimpleShearOfNarrowWaves) {
  const json data = support::reference("stability.json");
  compare("layer_modes_couette_fine", data.at("couette"), "k", 256, true,
          [&](const json& row, int layers) { return couette(data, row, layers); });
}

TEST(LayerModesFine, BagnoldsFlowOfNarrowWaves) {
  const json data = support::reference("stability.json");
  compare("layer_modes_bagnold_fine", data.at("bagnold"), "k_h", 256, true,
          [&](const json& row, int layers) { return bagnold(data, row, layers); });
}

}  // namespace
