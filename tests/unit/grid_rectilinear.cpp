#include <gtest/gtest.h>

#include "grid/rectilinear.hpp"

namespace {

using namespace talus::grid;

TEST(Rectilinear, GeometricCellsFillTheLengthAndKeepTheirRatio) {
  const auto nodes = geometric_nodes(7, 0.3, 4.0);
  EXPECT_EQ(nodes.front(), 0.0);
  EXPECT_DOUBLE_EQ(nodes.back(), 0.3);
  EXPECT_NEAR((nodes[7] - nodes[6]) / (nodes[1] - nodes[0]), 4.0, 1e-12);
  EXPECT_NEAR((nodes[3] - nodes[2]) / (nodes[2] - nodes[1]), (nodes[6] - nodes[5]) / (nodes[5] - nodes[4]), 1e-12);
  EXPECT_EQ(geometric_nodes(1, 2.0, 3.0), (std::vector<double>{0.0, 2.0}));
}

TEST(Rectilinear, KnowsItsNeighboursInARingAndInABox) {
  const Rectilinear ring({0.0, 1.0, 3.0, 6.0}, {0.0, 1.0, 2.0}, true);
  EXPECT_EQ(ring.n_faces(), 3);
  EXPECT_EQ(ring.column(-1), 2);
  EXPECT_EQ(ring.dx(3), 1.0);
  EXPECT_DOUBLE_EQ(ring.across_face(0), 2.0);
  EXPECT_FALSE(ring.is_end(0));
  const Rectilinear box(ring.x_nodes, ring.z_nodes, false);
  EXPECT_EQ(box.n_faces(), 4);
  EXPECT_FALSE(box.has_column(3));
  EXPECT_TRUE(box.is_end(3));
  EXPECT_DOUBLE_EQ(box.across_face(0), 1.0);
  EXPECT_DOUBLE_EQ(box.x_centre(1), 2.0);
}

}  // namespace
