#include "support/cavity.hpp"
#include "support/manufactured_box.hpp"
#include "support/manufactured_grain_wave.hpp"
#include "support/manufactured_wave.hpp"

/// The finest grids of the layer model's verification, minutes of computing.
namespace {

using namespace talus;
using enum grid::Spacing;

TEST(LayerFineGrids, ManufacturedFluid) {
  tests::expect_box_order("layer_manufactured_fine_newton",
                          {"newton", "fine", uniform, layer::Advection::central, {16, 32, 64}, 1.9, 1.9});
}
TEST(LayerFineGrids, ManufacturedGrainsBetweenWallsOnStretchedLayers) {
  tests::expect_box_order("layer_manufactured_fine_mui",
                          {"mui", "fine", clustered, layer::Advection::central, {16, 32, 64}, 1.9, 1.85});
}
TEST(LayerFineGrids, ManufacturedSurface) {
  tests::expect_wave_order("layer_manufactured_surface", tests::fluid_wave(),
                           {"fine", uniform, {16, 32, 64}, 1.95, 1.8, 1.85});
}
TEST(LayerFineGrids, ManufacturedSurfaceOfGrains) {
  tests::expect_wave_order("layer_grain_surface", tests::grain_wave(0.3),
                           {"fine", clustered, {16, 32, 64}, 1.95, 1.9, 1.9});
}
TEST(LayerFineGrids, CavityAtRe1000) { tests::expect_cavity(1, "1000_fine", {64, 128}, 2e-2, 1.8, 1.5e-2); }

}  // namespace
