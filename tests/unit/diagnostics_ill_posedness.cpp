#include "diagnostics/ill_posedness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {
using namespace talus;

const rheology::Classical base = rheology::classical(0.4, 0.9, 1.3);
const rheology::Law partial = rheology::partially_regularised(base, 1.3, 1.9, 0.05178);

TEST(IllPosedness, SharesAreOfTheAreaAndTheMeasuresDiffer) {
  // Table 2: C = 0 at I = 1.0297, q = 1 at 1.7495.
  const std::vector<double> I{0.5, 1.2, 2.0, 5.0, 99.0}, area{4.0, 3.0, 2.0, 1.0, 0.0};
  const auto share = diagnostics::ill_posedness(partial, I, area);
  EXPECT_DOUBLE_EQ(share.C_positive, 0.6);
  EXPECT_DOUBLE_EQ(share.growing, 0.3);
  EXPECT_DOUBLE_EQ(share.not_elliptic, 0.3);
}

TEST(IllPosedness, ClassicalCreepGrowsWithoutLosingEllipticity) {
  const std::vector<double> I{0.0, 0.01, 0.5, 3.5}, area{1.0, 1.0, 1.0, 1.0};
  const auto share = diagnostics::ill_posedness(base, I, area);
  EXPECT_DOUBLE_EQ(share.C_positive, 0.75);
  EXPECT_DOUBLE_EQ(share.growing, 0.75);
  EXPECT_EQ(share.not_elliptic, 0.0);
  EXPECT_EQ(diagnostics::ill_posedness(partial, I, area).growing, 0.25);
}

TEST(IllPosedness, NothingFlowingIsNothingIllPosedAndNaNIsRefused) {
  const std::vector<double> bad{std::nan("")}, none{0.0}, some{1.0}, both{1.0, 1.0};
  EXPECT_EQ(diagnostics::ill_posedness(partial, bad, none).growing, 0.0);
  EXPECT_THROW((void)diagnostics::ill_posedness(partial, bad, some), std::invalid_argument);
  EXPECT_THROW((void)diagnostics::ill_posedness(partial, some, both), std::invalid_argument);
}
}  // namespace
