#include "steady/ill_posed_depths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "steady/layer_mean.hpp"
#include "support/steady_cases.hpp"

namespace {
using namespace talus;
using steady::DepthRange;
using steady::UniformFlow;
using support::channel_named;

bool covers(const std::vector<DepthRange>& ranges, double depth) {
  bool inside = false;
  for (const auto& range : ranges) inside = inside || (range.from <= depth && depth < range.to);
  return inside;
}

steady::IllPosedDepths depths_of(const steady::Channel& c, const UniformFlow& flow) {
  return steady::ill_posed_depths(flow, steady::posedness_bounds(c.law));
}

TEST(IllPosedDepths, AreThoseWhereCAndQSaySo) {
  for (const char* law : {"classical", "partial"})
    for (const double mu : {0.41, 0.5, 0.7, 0.85, 0.899, 1.2, 2.0, 5.0}) {
      const auto c = channel_named("T2_table2", law);
      const auto flow = UniformFlow::at_friction(c, mu);
      if (!flow) continue;
      const auto found = depths_of(c, *flow);
      for (int i = 0; i < 997; ++i) {
        const double depth = flow->depth() * i / 997.0;
        const auto response = rheology::response(c.law, flow->inertial_number(-depth));
        EXPECT_EQ(covers(found.C_positive, depth), rheology::condition_C(response) > 0.0) << law << mu << " " << depth;
        EXPECT_EQ(covers(found.q_beyond, depth), response.q >= 1.0) << law << mu << " " << depth;
      }
    }
}

TEST(IllPosedDepths, OfTheClassicalLawLieAboveAndBelow) {
  const auto c = channel_named("T2_table2", "classical");
  const auto steep = UniformFlow::at_friction(c, 0.85), gentle = UniformFlow::at_friction(c, 0.5);
  const auto both = depths_of(c, *steep), low = depths_of(c, *gentle);
  const auto depth_at = [&](double mu, double I) { return (mu - rheology::friction(c.law, I)) * c.gap / c.mu_w; };
  ASSERT_EQ(both.C_positive.size(), 2U);
  EXPECT_EQ(both.C_positive[0].from, 0.0);
  EXPECT_NEAR(both.C_positive[0].to / depth_at(0.85, 2.99571172836610), 1.0, 1e-12);
  EXPECT_NEAR(both.C_positive[1].from / depth_at(0.85, 0.0517818300563480), 1.0, 1e-12);
  EXPECT_EQ(both.C_positive[1].to, steep->depth());
  ASSERT_EQ(low.C_positive.size(), 1U);
  EXPECT_GT(low.C_positive[0].from, 0.0);
  EXPECT_NEAR(*both.C_margin, 2.99571172836610 - 1.3 * 0.45 / 0.05, 1e-12);
  EXPECT_FALSE(both.q_margin.has_value());
  EXPECT_GT(both.C_surface, 0.0);
  EXPECT_LT(low.C_surface, 0.0);
}

TEST(IllPosedDepths, OfTheRegularisedLawBeginAtTheSurface) {
  const auto c = channel_named("T2_table2", "partial");
  const auto at_surface = [&](double I) { return UniformFlow::at_friction(c, rheology::friction(c.law, I)); };
  const auto inside = depths_of(c, *at_surface(1.0));
  EXPECT_TRUE(inside.C_positive.empty());
  EXPECT_NEAR(*inside.C_margin, 0.02973050686654, 1e-12);
  EXPECT_NEAR(*inside.q_margin, 0.74952255192233, 1e-12);
  const auto damped = depths_of(c, *at_surface(1.5));
  EXPECT_EQ(damped.C_positive.size(), 1U);
  EXPECT_TRUE(damped.q_beyond.empty());
  const auto outside = depths_of(c, *at_surface(2.0));
  ASSERT_EQ(outside.q_beyond.size(), 1U);
  EXPECT_LT(outside.q_beyond[0].to, outside.C_positive[0].to);
  EXPECT_LT(*outside.q_margin, 0.0);
}

TEST(IllPosedDepths, OfAFlowWithoutWallsAreAllOrNone) {
  auto c = channel_named("T2_table2", "classical");
  c.mu_w = 0.0;
  const auto slow = UniformFlow::at_friction(c, 0.41, 0.02), fast = UniformFlow::at_friction(c, 0.6, 0.02);
  ASSERT_EQ(depths_of(c, *slow).C_positive.size(), 1U);
  EXPECT_EQ(depths_of(c, *slow).C_positive[0].to, 0.02);
  EXPECT_TRUE(depths_of(c, *fast).C_positive.empty());
}

TEST(LayerMean, IsTakenToTheBaseOrToOnePercentOfTheSurfaceSpeed) {
  auto c = channel_named("T2_table2", "partial");
  const auto heap = UniformFlow::at_friction(c, 1.0);
  const auto free = steady::layer_mean(*heap);
  EXPECT_FALSE(free.to_base);
  EXPECT_NEAR(heap->speed(-free.depth) / heap->surface_speed(), 0.01, 1e-12);
  EXPECT_NEAR(free.speed, heap->flux_above(free.depth) / (c.grains.rho() * c.gap * free.depth), 1e-15);
  EXPECT_NEAR(free.froude, free.speed / std::sqrt(9.81 * free.depth * std::cos(heap->zeta())), 1e-14);
  const auto layer = UniformFlow::at_friction(c, 1.0, 0.004);
  const auto based = steady::layer_mean(*layer);
  EXPECT_TRUE(based.to_base);
  EXPECT_EQ(based.depth, 0.004);
  EXPECT_NEAR(based.speed, layer->flux() / (c.grains.rho() * c.gap * 0.004), 1e-15);
  EXPECT_FALSE(steady::layer_mean(*UniformFlow::at_friction(c, 1.0, 0.1)).to_base);
  c.mu_w = 0.0;
  const auto bagnold = UniformFlow::at_friction(c, 0.5, 0.02);
  EXPECT_NEAR(steady::layer_mean(*bagnold).speed / bagnold->surface_speed(), 0.6, 1e-14);
}
}  // namespace
