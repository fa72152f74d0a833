#include "diagnostics/flow_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace {
using namespace talus;
using diagnostics::FlowClass;

const rheology::Classical base = rheology::classical(0.4, 0.9, 1.3);
const rheology::Law classical = base;
const rheology::Law partial = rheology::partially_regularised(base, 1.3, 1.9, 0.05178);

FlowClass class_at(const rheology::Law& law, double I, bool capped = false) {
  return diagnostics::flow_class(rheology::response(law, I), capped);
}

/// Table 2: classical C = 0 at I = 0.05178 and 2.9957; partial C = 0 at 1.0297, q = 1 at 1.7495.
TEST(FlowClass, FollowsTheNeutralPointsOfTableTwo) {
  EXPECT_EQ(class_at(classical, 0.0517), FlowClass::ill_posed);
  EXPECT_EQ(class_at(classical, 0.0519), FlowClass::well_posed);
  EXPECT_EQ(class_at(classical, 2.99), FlowClass::well_posed);
  EXPECT_EQ(class_at(classical, 3.00), FlowClass::ill_posed);
  EXPECT_EQ(class_at(partial, 0.001), FlowClass::well_posed);
  EXPECT_EQ(class_at(partial, 1.029), FlowClass::well_posed);
  EXPECT_EQ(class_at(partial, 1.031), FlowClass::damped);
  EXPECT_EQ(class_at(partial, 1.749), FlowClass::damped);
  EXPECT_EQ(class_at(partial, 1.751), FlowClass::ill_posed);
}

TEST(FlowClass, TheCapDecaysWhateverTheLawWouldDo) {
  EXPECT_EQ(class_at(classical, 0.001, true), FlowClass::capped);
  const auto response = rheology::response(classical, 0.001);
  EXPECT_DOUBLE_EQ(diagnostics::growth_per_square(response, true, 3.0, 1500.0), -0.002);
  EXPECT_DOUBLE_EQ(diagnostics::growth_per_square(response, false, 3.0, 1500.0),
                   0.002 * rheology::max_growth(response));
  EXPECT_GT(diagnostics::growth_per_square(response, false, 3.0, 1500.0), 0.0);
  EXPECT_TRUE(std::isinf(diagnostics::growth_per_square(rheology::response(partial, 2.0), false, 3.0, 1500.0)));
}

TEST(FlowClass, SharesAreOfTheWeight) {
  const std::vector<FlowClass> classes{FlowClass::capped, FlowClass::well_posed, FlowClass::ill_posed,
                                       FlowClass::well_posed, FlowClass::damped};
  const auto shares = diagnostics::class_shares(classes, std::vector<double>{1.0, 2.0, 3.0, 4.0, 0.0});
  EXPECT_DOUBLE_EQ(shares[0], 0.1);
  EXPECT_DOUBLE_EQ(shares[1], 0.6);
  EXPECT_DOUBLE_EQ(shares[2], 0.0);
  EXPECT_DOUBLE_EQ(shares[3], 0.3);
  const auto still = diagnostics::class_shares(classes, std::vector<double>(5, 0.0));
  for (const double share : still) EXPECT_EQ(share, 0.0);
  EXPECT_THROW((void)diagnostics::class_shares(classes, std::vector<double>{1.0}), std::invalid_argument);
  EXPECT_THROW((void)diagnostics::class_shares(classes, std::vector<double>{1.0, 1.0, 1.0, 1.0, std::nan("")}),
               std::invalid_argument);
}

TEST(FlowShares, SharesOfFluxWeighTheSpeedAndNamesAreOfTheirClass) {
  const std::vector<diagnostics::FlowCell> cells{{0.5, FlowClass::well_posed, 3.0, 1.0},
                                                 {2.0, FlowClass::ill_posed, 1.0, 2.0},
                                                 {std::nan(""), FlowClass::capped, 0.0, std::nan("")}};
  const auto shares = diagnostics::flow_shares(partial, cells);
  std::map<std::string, double> named;
  for (const auto& number : diagnostics::share_numbers()) named[number.name] = number.value(shares);
  EXPECT_DOUBLE_EQ(named.at("class_well_posed_area"), 0.75);
  EXPECT_DOUBLE_EQ(named.at("class_well_posed_flux"), 0.6);
  EXPECT_DOUBLE_EQ(named.at("class_ill_posed_area"), 0.25);
  EXPECT_DOUBLE_EQ(named.at("class_ill_posed_flux"), 0.4);
  EXPECT_DOUBLE_EQ(named.at("class_capped_flux"), 0.0);
  EXPECT_DOUBLE_EQ(named.at("growing_share"), 0.25);
}
}  // namespace
