#include <gtest/gtest.h>

#include "config/spelling.hpp"

namespace {
using talus::config::edit_distance;
using talus::config::nearest;

TEST(Spelling, CountsSingleLetterEdits) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("rho_star", "rho_sta"), 1U);
  EXPECT_EQ(edit_distance("height", "heihgt"), 1U);
  EXPECT_EQ(edit_distance("phi", "Phi"), 0U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(Spelling, OffersNothingWhenNothingIsNear) {
  EXPECT_EQ(nearest("layrs", {"columns", "layers"}), "layers");
  EXPECT_FALSE(nearest("viscosity", {"columns", "layers"}).has_value());
  EXPECT_FALSE(nearest("x", {}).has_value());
}
}  // namespace
