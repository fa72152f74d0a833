#include "support/cavity.hpp"

namespace {

using talus::tests::expect_cavity;

TEST(LayerCavity, Re100MeetsTheTables) { expect_cavity(0, "100", {16, 32, 64}, 1e-2, 1.8, 2e-3); }
TEST(LayerCavity, Re1000MeetsTheTables) { expect_cavity(1, "1000", {32, 64}, 6e-2, 1.8, 6e-2); }

}  // namespace
