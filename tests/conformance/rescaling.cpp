#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "ida/ida.hpp"
#include "support/example_scene.hpp"
#include "support/random_state.hpp"
#include "support/rescaled.hpp"

/// The physics knows no metre, second or kilogram: in units that are powers of two of ours every registered model gives the
/// same mantissas, entry by entry of residual and Jacobian, and through a run.
namespace {

using namespace talus;
using tests::Case;
using tests::Units;

const std::vector<Units> units_of_choice{{7, 0, 0}, {0, -5, 0}, {0, 0, 11}, {-3, 4, -6}};

class Rescaling : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Conformance, Rescaling, testing::ValuesIn(tests::every_case()),
                         [](const auto& each) { return each.param.model + "_" + each.param.scene; });

std::vector<double> times_units(std::vector<double> v, const core::Layout& layout, const Units& units, double extra) {
  for (core::Index i = 0; i < layout.size(); ++i) v[i] *= extra * units.factor(layout.field(i).unit);
  return v;
}

/// The factor of each row: a power of two, to a relative `rounding`, and if they are all `alike` the same for all of a field. Not a
/// number for rows that are zero. Reports rows that break this.
std::vector<double> row_factors(const core::DaeSystem& system, const std::vector<double>& r,
                                const std::vector<double>& r_in_units, bool alike, double rounding) {
  std::map<int, double> of_field;
  std::vector<double> factors(r.size(), std::numeric_limits<double>::quiet_NaN());
  int odd = 0;
  for (core::Index i = 0; i < system.layout().size(); ++i) {
    if (r[i] == 0.0 && r_in_units[i] == 0.0) continue;
    const double ratio = r_in_units[i] / r[i], factor = std::exp2(std::round(std::log2(ratio)));
    const double first = of_field.emplace(system.layout().field_of[i], factor).first->second;
    const bool same = std::abs(ratio - factor) <= rounding * factor && (factor == first || !alike);
    factors[i] = factor;
    if (!same && ++odd < 4) ADD_FAILURE() << system.describe(i) << ": " << r_in_units[i] << " from " << r[i];
  }
  EXPECT_EQ(odd, 0);
  return factors;
}

TEST_P(Rescaling, ChangesNoBitOfAnyMantissaOfResidualAndJacobian) {
  for (const auto& settings :
       std::vector<std::vector<std::string>>{{"rheology.cap=hard"},
                                             {"rheology.cap=smooth", "rheology.rate_floor=0.1"},
                                             {"rheology.cap=none", "rheology.p_0=0", "rheology.rate_floor=0.1"},
                                             {"rheology.cap=hard", "inflow.momentum=true", "rheology.law=classical"}}) {
    const auto scene = GetParam().read(9, 5, settings);
    const auto simulation = app::model(scene.model).build(scene);
    const auto& system = *simulation.system;
    const auto& pattern = system.pattern();
    // The triangle integrates over roots of depths, and the root of an odd power of two is none.
    const double rounding = GetParam().model == "triangle" ? 1e-12 : 0.0;
    std::vector<double> y, yp, r(pattern.n()), r_in_units(r), J(pattern.n_nonzeros()), J_in_units(J);
    for (const double speed : {0.0, 1e-3, 0.3}) {
      tests::RandomState{speed}.fill(system, 3, y, yp);
      system.residual(0.1, y, yp, r);
      system.jacobian(0.1, y, yp, 50.0, J);
      for (const auto& units : units_of_choice) {
        SCOPED_TRACE(testing::Message() << settings.size() << " settings, " << speed << " m/s, units 2^" << units.length
                                        << " 2^" << units.time << " 2^" << units.mass);
        const double T = units.factor(0, 1, 0);
        const tests::RescaledSystem other(scene, units);
        const auto y_in_units = times_units(y, system.layout(), units, 1.0);
        const auto yp_in_units = times_units(yp, system.layout(), units, 1.0 / T);
        other.residual(0.1 * T, y_in_units, yp_in_units, r_in_units);
        // Under a lid some rows that are counted with p hold volumes.
        auto factors = row_factors(system, r, r_in_units, !scene.box.lid, rounding);
        other.jacobian(0.1 * T, y_in_units, yp_in_units, 50.0 / T, J_in_units);
        int odd = 0;
        for (core::Index j = 0; j < pattern.n(); ++j)
          for (auto e = pattern.column_starts()[j]; e < pattern.column_starts()[j + 1]; ++e) {
            const core::Index i = pattern.rows()[e];
            if (J[e] == 0.0 && J_in_units[e] == 0.0) continue;
            const double unit = units.factor(system.layout().field(j).unit);
            if (std::isnan(factors[i])) factors[i] = J_in_units[e] / J[e] * unit;
            const double expected = factors[i] / unit * J[e];
            if (std::abs(J_in_units[e] - expected) > rounding * std::abs(expected) && ++odd < 4)
              ADD_FAILURE() << system.describe(i) << " by " << system.describe(j) << ": " << J_in_units[e] << " from "
                            << J[e];
          }
        EXPECT_EQ(odd, 0);
      }
    }
  }
}

std::vector<double> state_after(const core::DaeSystem& system, const ida::Options& options,
                                const std::vector<double>& y, const std::vector<double>& yp, double t) {
  core::Observer nobody;
  ida::Ida integrator(system, options);
  integrator.start(0.0, y, yp);
  integrator.advance(t, nobody);
  const auto now = integrator.current();
  return {now.y.begin(), now.y.end()};
}

/// The column also takes the same steps with the same pivots, and its runs keep every bit. The layer's linear solvers choose their
/// pivots by the size of entries of unlike units: its runs agree to rounding, and to the last bit where only the mass unit changes.
/// (Not so in the two-fluid model, whose pivots then compare rows that hold a mass with rows that hold a volume.)
/// In the periodic chute rounding tips a decision of the integrator, whether factors are kept: it agrees to ten tolerances. Newton's
/// method is held free of doubt: in doubt it goes down to rounding, which then tips its decisions in every scene of the layer. In the
/// two-fluid model, whose pivots change, it is also held free of secants: which of them count is decided by sizes, too.
TEST_P(Rescaling, ChangesNoMoreThanRoundingThroughARun) {
  const bool two_fluid = GetParam().model == "two_fluid";
  for (const char* solver : {"klu", "banded"}) {
    const auto scene = GetParam().read(20, 8, {"rheology.cap=hard", std::string("integrator.linear_solver=") + solver});
    const auto simulation = app::model(scene.model).build(scene);
    const auto& system = *simulation.system;
    const auto& layout = system.layout();
    std::vector<double> y(layout.size()), yp(y);
    system.initial_state(0.0, y, yp);
    auto free_of_doubt = app::make_integrator_options(scene);
    free_of_doubt.newton.doubt = 0;
    if (two_fluid) free_of_doubt.newton.depth = 0;
    const auto expected = state_after(system, free_of_doubt, y, yp, 0.3);
    const double rounding = scene.box.periodic ? 10.0 * scene.integration.rtol : 1e-12;
    std::map<std::string, double> size;  // of the fields of a unit
    for (core::Index i = 0; i < layout.size(); ++i)
      size[layout.field(i).unit] =
          std::max({size[layout.field(i).unit], std::abs(expected[i]), layout.field(i).absolute_tolerance});
    for (const auto& units : units_of_choice) {
      const double T = units.factor(0, 1, 0);
      const tests::RescaledSystem other(scene, units);
      auto options = app::make_integrator_options(tests::rescaled(scene, units));
      options.newton.doubt = 0;
      options.newton.depth = free_of_doubt.newton.depth;
      options.start_step *= T;
      options.min_step *= T;
      const auto got = state_after(other, options, times_units(y, layout, units, 1.0),
                                   times_units(yp, layout, units, 1.0 / T), 0.3 * T);
      const bool mass_alone = units.length == 0 && units.time == 0 && !two_fluid;
      const double bound = GetParam().model == "column" || mass_alone ? 0.0 : rounding;
      for (core::Index i = 0; i < layout.size(); ++i) {
        const auto& unit = layout.field(i).unit;
        EXPECT_NEAR(got[i] / units.factor(unit), expected[i], bound * size[unit])
            << solver << ", units 2^" << units.length << " 2^" << units.time << " 2^" << units.mass << ": "
            << system.describe(i);
      }
    }
  }
}

}  // namespace
