#include "support/manufactured_wave.hpp"

namespace {

using talus::tests::expect_wave_order, talus::tests::Taylor2;
namespace grid = talus::grid;

TEST(LayerManufacturedSurface, FlowHasNoDivergenceAndMovesWithItsSurface) {
  for (const double x : {0.0, 0.13, 0.4, 0.77}) {
    for (const double t : {0.0, 0.3, 1.1}) {
      const auto H = talus::tests::wave_surface(Taylor2::variable(x, Taylor2::x), Taylor2::variable(t, Taylor2::t));
      for (const double sigma : {0.0, 0.2, 0.9, 1.0}) {
        const auto f = talus::tests::flow_at(talus::tests::wave_flow, x, sigma * H.value, t);
        EXPECT_NEAR(f.u.first[Taylor2::x] + f.w.first[Taylor2::z], 0.0, 1e-13);
        if (sigma == 0.0) {
          EXPECT_EQ(f.u.value, 0.0);
          EXPECT_EQ(f.w.value, 0.0);
        }
        if (sigma == 1.0) { EXPECT_NEAR(f.w.value, H.first[Taylor2::t] + f.u.value * H.first[Taylor2::x], 1e-13); }
      }
    }
  }
}

TEST(LayerManufacturedSurface, OrderIsTwoOnUniformLayers) { expect_wave_order({"uniform", grid::Spacing::uniform}); }
TEST(LayerManufacturedSurface, OrderIsTwoOnStretchedLayers) {
  expect_wave_order({"stretched", grid::Spacing::clustered});
}

}  // namespace
