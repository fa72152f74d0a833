#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "rheology/well_posedness.hpp"
#include "steady/sensitivity.hpp"
#include "steady/slope.hpp"

/// The derivatives of the flux and speed integrals, and of what hangs on them, against differences of `UniformFlow` itself.
namespace {
using namespace talus::steady;
namespace rheology = talus::rheology;

const rheology::Classical base{0.4, 0.9, 1.3};
const VariedChannel partial{
    {{2500.0, 0.6, 0.00073}, rheology::partially_regularised(base, 1.3, 1.9, 0.05178), 0.003, 0.3727, 9.81}};
VariedChannel following() {
  VariedChannel out = partial;
  out.channel.law = rheology::partially_regularised(base, 1.3, 1.9);
  out.I_N_follows = true;
  return out;
}
VariedChannel classical() {
  VariedChannel out = partial;
  out.channel.law = base;
  return out;
}

using Quantity = std::function<double(const Channel&, double tan_zeta, double depth)>;
using Exact = std::function<Sensitivity(const VariedChannel&, const UniformFlow&)>;

double difference(const std::function<double(double)>& f, double at, double step) {
  return (8.0 * (f(at + step) - f(at - step)) - (f(at + 2.0 * step) - f(at - 2.0 * step))) / (12.0 * step);
}

void expect_same(const VariedChannel& varied, double T, double depth, const Quantity& quantity, const Exact& exact) {
  const auto flow = UniformFlow::at_friction(varied.channel, T).value();
  const Sensitivity s = exact(varied, flow);
  const double value = quantity(varied.channel, T, depth);
  EXPECT_NEAR(s.value, value, 1e-10 * std::abs(value));
  EXPECT_NEAR(s.by_slope, difference([&](double t) { return quantity(varied.channel, t, depth); }, T, 1e-3 * (T - 0.4)),
              1e-6 * std::abs(s.by_slope));
  if (depth > 0.0) {
    EXPECT_NEAR(s.by_depth, difference([&](double h) { return quantity(varied.channel, T, h); }, depth, 1e-3 * depth),
                1e-7 * std::abs(s.by_depth));
  }
  const Gradient values = varied.values();
  for (int i = 0; i < n_parameters; ++i) {
    if (!uses(varied.channel.law, Parameter{i})) continue;
    const auto moved = [&](double x) {
      Gradient v = values;
      v[i] = x;
      return quantity(varied.with(v).channel, T, depth);
    };
    EXPECT_NEAR(s.by[i], difference(moved, values[i], 2e-4 * values[i]), 1e-6 * std::abs(value / values[i]))
        << parameter_names[i];
  }
}

class EveryLaw : public testing::TestWithParam<std::tuple<int, double>> {
 protected:
  [[nodiscard]] VariedChannel channel() const {
    const int law = std::get<0>(GetParam());
    return law == 0 ? partial : law == 1 ? following() : classical();
  }
  [[nodiscard]] double T() const { return std::get<1>(GetParam()); }
};

TEST_P(EveryLaw, FluxSensitivity) {
  const auto flux = [](const Channel& c, double t, double) { return UniformFlow::at_friction(c, t)->flux(); };
  expect_same(channel(), T(), 0.0, flux, flux_sensitivity);
}

TEST_P(EveryLaw, SpeedSensitivityAtTheSurfaceAndBelow) {
  const auto speed = [](const Channel& c, double t, double h) { return UniformFlow::at_friction(c, t)->speed(-h); };
  for (const double h : {0.0, 2e-4, 6e-4})
    expect_same(channel(), T(), h, speed, [&](const auto& v, const auto& f) { return speed_sensitivity(v, f, h); });
}

TEST_P(EveryLaw, SurfaceSensitivities) {
  const auto I = [](const Channel& c, double t, double) {
    return UniformFlow::at_friction(c, t)->inertial_number(0.0);
  };
  expect_same(channel(), T(), 0.0, I, surface_inertial_number);
  const auto response = [&](const Channel& c, double t) { return rheology::response(c.law, I(c, t, 0.0)); };
  expect_same(
      channel(), T(), 0.0, [&](const Channel& c, double t, double) { return response(c, t).q; }, surface_q);
  expect_same(
      channel(), T(), 0.0, [&](const Channel& c, double t, double) { return rheology::condition_C(response(c, t)); },
      surface_C);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, testing::Combine(testing::Values(0, 1, 2), testing::Values(0.6, 0.85)));

TEST(Sensitivity, OfTheSlopeThatCarriesAFlux) {
  const auto flow = flow_of_flux(partial.channel, 0.0046).value();
  const auto flux = flux_sensitivity(partial, flow);
  const Sensitivity slope{flow.tan_zeta(), {}, 1.0};
  const auto total = at_fixed_flux(slope, flux);
  const Gradient values = partial.values();
  for (int i = 0; i < n_parameters; ++i) {
    const auto moved = [&](double x) {
      Gradient v = values;
      v[i] = x;
      return flow_of_flux(partial.with(v).channel, 0.0046)->tan_zeta();
    };
    EXPECT_NEAR(total.by[i], difference(moved, values[i], 2e-4 * values[i]), 1e-6 / values[i]) << parameter_names[i];
  }
}

TEST(Sensitivity, NewtonFindsTheFlowFromAnyGuessOrNone) {
  const double exact = flow_of_flux(partial.channel, 0.0046)->tan_zeta();
  for (const auto guess : {std::optional<double>(), std::optional(0.2), std::optional(1.1), std::optional(3.0)})
    EXPECT_NEAR(flow_near(partial, 0.0046, guess)->flow.tan_zeta(), exact, 1e-11);
  EXPECT_FALSE(flow_near(classical(), 0.006, 0.8));
}

TEST(Sensitivity, KnowsWhichParametersALawHas) {
  EXPECT_FALSE(uses(base, Parameter::alpha));
  EXPECT_TRUE(uses(base, Parameter::I_0));
  EXPECT_FALSE(uses(rheology::Constant{0.4}, Parameter::mu_d));
  EXPECT_EQ(value_of(partial.channel, Parameter::W), 0.003);
}
}  // namespace
