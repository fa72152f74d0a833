#include "steady/slope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/steady_cases.hpp"

/// The exact steady uniform flow against independent 25-digit values: tables 1 and 2 and the cases of figures 20 and
/// 21.
namespace {
using namespace talus;
using nlohmann::json;
using steady::Channel;
using steady::UniformFlow;
using support::channel_of;
using support::off;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double tolerance = 1e-10;

const json& cases() {
  static const json all = support::reference("steady_uniform.json").at("cases");
  return all;
}

TEST(UniformFlow, ProfilesFluxesAndDepthsEqualTheReference) {
  int compared = 0, unsolvable = 0;
  for (const auto& each : cases())
    for (const auto& row : each["flows"])
      for (const std::string law : {"partial", "classical"}) {
        const auto& exact = row[law];
        const auto flow = UniformFlow::at(channel_of(each["parameters"], law), row["zeta_deg"].get<double>() * degree);
        ASSERT_EQ(static_cast<bool>(flow), exact.is_object())
            << each["name"] << law << row["zeta_deg"] << flow.reason();
        if (!flow) {
          ++unsolvable;
          continue;
        }
        const std::string where = each["name"].get<std::string>() + " " + law + " " + row["zeta_deg"].dump();
        EXPECT_LT(off(flow->z_st(), exact["z_st"]), 1e-12) << where;
        EXPECT_LT(off(flow->inertial_number(0.0), exact["I_surf"]), tolerance) << where;
        EXPECT_LT(off(flow->surface_speed(), exact["u_surf"]), tolerance) << where;
        EXPECT_LT(off(flow->flux(), exact["Q_kg_s"]), tolerance) << where;
        for (const auto& point : exact["profile_z_u_I"]) {
          EXPECT_LT(off(flow->speed(point[0]), point[1]), tolerance) << where << " z " << point[0];
          EXPECT_LT(off(flow->inertial_number(point[0]), point[2]), tolerance) << where << " z " << point[0];
          ++compared;
        }
      }
  EXPECT_GT(compared, 300);
  EXPECT_GE(unsolvable, 20);
}

TEST(UniformFlow, SlopeOfFluxEqualsTheReference) {
  for (const auto& each : cases())
    for (const auto& row : each["zeta_of_Q"])
      for (const std::string law : {"partial", "classical"}) {
        const auto& exact = row["zeta_" + law + "_deg"];
        const auto zeta = steady::slope_of_flux(channel_of(each["parameters"], law), row["Q"]);
        ASSERT_EQ(static_cast<bool>(zeta), exact.is_number()) << each["name"] << law << row["Q"];
        if (zeta) { EXPECT_LT(off(*zeta / degree, exact), tolerance) << each["name"] << law << row["Q"]; }
      }
}

TEST(UniformFlow, FluxFollowsGapAndWallFriction) {
  for (const auto& each : cases())
    for (const auto& row : each["scan"])
      for (const std::string law : {"partial", "classical"}) {
        json p = each["parameters"];
        p["W"] = row["W"];
        p["mu_w"] = row["muw"];
        const auto flow = UniformFlow::at(channel_of(p, law), row["zeta_deg"].get<double>() * degree);
        const auto& exact = row["Q_" + law];
        ASSERT_EQ(static_cast<bool>(flow), exact.is_number());
        if (flow) { EXPECT_LT(off(flow->flux(), exact), tolerance); }
        if (law == "partial") { EXPECT_LT(off(flow->surface_speed(), row["u_surf"]), tolerance); }
      }
}

TEST(UniformFlow, WithoutWallsItIsBagnoldsFlow) {
  for (const auto& each : cases())
    for (const auto& row : each["bagnold"])
      for (const std::string law : {"partial", "classical"}) {
        json p = each["parameters"];
        p["mu_w"] = 0.0;
        const Channel channel = channel_of(p, law);
        const double h = row["h"], rho_W = channel.grains.rho() * channel.gap;
        const auto flow = UniformFlow::at(channel, row["zeta_deg"].get<double>() * degree, h);
        const auto& exact = row[law];
        ASSERT_EQ(static_cast<bool>(flow), exact.is_object());
        if (!flow) continue;
        EXPECT_EQ(flow->depth(), h);
        EXPECT_LT(off(flow->inertial_number(-0.3 * h), exact["I"]), tolerance);
        EXPECT_LT(off(flow->surface_speed(), exact["u_surf"]), tolerance);
        EXPECT_LT(off(flow->speed(-0.5 * h), exact["u_half"]), tolerance);
        EXPECT_LT(off(flow->flux() / rho_W, exact["q_m2_s"]), tolerance);
      }
}

TEST(UniformFlow, LargestClassicalFluxIsClosedFormAndApproached) {
  for (const auto& each : cases()) {
    const Channel channel = channel_of(each["parameters"], "classical");
    EXPECT_LT(off(steady::maximal_flux(channel).value(), each["Q_max_classical"]), 1e-12) << each["name"];
    const double steepest = std::atan(each["parameters"]["mu_d"].get<double>());
    EXPECT_LT(off(steepest / degree, each["zeta_max_classical_deg"]), 1e-12);
    EXPECT_LT(off(UniformFlow::at(channel, steepest * (1.0 - 1e-14))->flux(), each["Q_max_classical"]), 1e-9)
        << each["name"];
    EXPECT_FALSE(steady::maximal_flux(channel_of(each["parameters"], "partial")).has_value());
  }
}
}  // namespace
