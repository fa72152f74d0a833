#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "steady/regularised_profile.hpp"
#include "steady/slope.hpp"
#include "support/steady_cases.hpp"

/// What no steady flow can be computed for is refused by the name of the parameter, with what it must be.
namespace {
using namespace talus;
using steady::Channel;
using steady::UniformFlow;
using support::channel_named;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refusal(const auto& act) {
  try {
    act();
  } catch (const std::invalid_argument& error) { return error.what(); }
  return "accepted";
}

TEST(SteadyRefusals, NameTheParameterAndItsRange) {
  const Channel good = channel_named("T2_table2", "partial");
  struct Case {
    Channel channel;
    double zeta, thickness;
    const char* words;
  };
  const auto with = [&](auto&& change) {
    Channel c = good;
    change(c);
    return c;
  };
  const double nan = std::nan("");
  for (const auto& [channel, zeta, thickness, words] :
       {Case{with([](Channel& c) { c.gap = 0.0; }), 0.5, infinity, "gap = 0 must be finite and above 0 m"},
        Case{with([](Channel& c) { c.gap = -1e-9; }), 0.5, infinity, "gap = -1e-09 must be finite and above 0 m"},
        Case{with([&](Channel& c) { c.gap = nan; }), 0.5, infinity, "gap = nan must be finite and above 0 m"},
        Case{with([](Channel& c) { c.mu_w = -1e-12; }), 0.5, infinity, "mu_w = -1e-12 must be finite and at least 0"},
        Case{with([](Channel& c) { c.mu_w = infinity; }), 0.5, infinity, "mu_w = inf must be finite and at least 0"},
        Case{with([](Channel& c) { c.gravity = 0.0; }), 0.5, infinity, "gravity = 0 must be finite and above 0 m/s2"},
        Case{with([](Channel& c) { c.grains.d = 0.0; }), 0.5, infinity, "d = 0 must be"},
        Case{with([](Channel& c) { c.grains.Phi = 1.1; }), 0.5, infinity, "Phi = 1.1 must be"},
        Case{with([](Channel& c) { c.grains.rho_star = infinity; }), 0.5, infinity, "rho_star = inf must be"},
        Case{with([](Channel& c) { c.mu_w = 0.0; }), 0.5, infinity,
             "thickness = inf must be finite where there is no wall friction (mu_w = 0)"},
        Case{good, 0.5, 0.0, "thickness = 0 must be above 0 m"},
        Case{good, 0.0, infinity, "zeta = 0 must be above 0 and below pi/2 rad"},
        Case{good, 1.6, infinity, "zeta = 1.6 must be above 0 and below pi/2 rad"},
        Case{good, nan, infinity, "zeta = nan must be above 0 and below pi/2 rad"}})
    EXPECT_NE(refusal([&] { (void)UniformFlow::at(channel, zeta, thickness); }).find(words), std::string::npos)
        << refusal([&] { (void)UniformFlow::at(channel, zeta, thickness); });
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    EXPECT_NE(refusal([&] { (void)steady::flow_of_flux(good, bad); }).find("must be finite and above 0 kg/s"),
              std::string::npos);
    EXPECT_NE(refusal([&] { (void)steady::flow_of_mean_speed(good, bad); }).find("must be finite and above 0 m/s"),
              std::string::npos);
  }
}

TEST(SteadyRefusals, ALawThatWeakensIsRefused) {
  EXPECT_NE(refusal([] { (void)rheology::classical(0.9, 0.4, 1.3); }).find("mu_d = 0.4 must be at least mu_s = 0.9"),
            std::string::npos);
  EXPECT_NE(refusal([] {
              (void)rheology::partially_regularised({0.9, 0.4, 1.3}, 1.3, 1.9, 0.05);
            }).find("mu_d = 0.4 must be at least mu_s = 0.9"),
            std::string::npos);
}

TEST(SteadyRefusals, ALawThatDoesNotStrengthenSelectsNoSpeed) {
  Channel flat = channel_named("T2_table2", "classical");
  for (const rheology::Law& law :
       {rheology::Law(rheology::classical(0.4, 0.4, 1.3)), rheology::Law(rheology::constant(0.4))}) {
    flat.law = law;
    EXPECT_FALSE(UniformFlow::at_friction(flat, 0.5));
    EXPECT_FALSE(steady::maximal_flux(flat).has_value());
    for (const auto& none : {steady::flow_of_flux(flat, 0.001), steady::flow_of_mean_speed(flat, 0.1)}) {
      EXPECT_FALSE(none);
      EXPECT_NE(none.reason().find("does not select a speed"), std::string::npos) << none.reason();
    }
  }
}

TEST(SteadyRefusals, AFlowBeyondTheNumbersOfAComputerIsNotGivenAsInfinityOrZero) {
  Channel c = channel_named("T2_table2", "partial");
  for (const double mu_w : {1e-200, 5e-324}) {
    c.mu_w = mu_w;
    const auto huge = UniformFlow::at_friction(c, 0.6);
    EXPECT_FALSE(huge);
    EXPECT_NE(huge.reason().find("outside 1e-280 to 1e+280"), std::string::npos) << huge.reason();
    EXPECT_NE(huge.reason().find("mu_w = "), std::string::npos) << huge.reason();
  }
  c.mu_w = 0.3727;
  const auto tiny = UniformFlow::at_friction(c, 1e-60);
  EXPECT_FALSE(tiny);
  EXPECT_NE(tiny.reason().find("tan zeta = 1e-60"), std::string::npos) << tiny.reason();
  EXPECT_NE(tiny.reason().find("outside 1e-280 to 1e+280"), std::string::npos) << tiny.reason();
}

TEST(SteadyRefusals, ASearchThatWouldEndUprightOrAtRestSaysSo) {
  Channel c = channel_named("T2_table2", "partial");
  const auto upright = steady::flow_of_flux(c, 1e80);
  EXPECT_FALSE(upright);
  EXPECT_NE(upright.reason().find("cannot be told from 90 degrees"), std::string::npos) << upright.reason();
  const steady::RegularisedLayer layer{c, {}, 1e-3, 0.05};
  const auto flat = steady::slope_of_flux(layer, 1e-60, 200), steep = steady::slope_of_flux(layer, 1e12, 200);
  EXPECT_FALSE(flat);
  EXPECT_NE(flat.reason().find("between 0.057 and 89.98 degrees"), std::string::npos) << flat.reason();
  EXPECT_FALSE(steep);
}
}  // namespace
