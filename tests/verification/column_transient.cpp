#include <gtest/gtest.h>

#include <cstdio>

#include "support/column_run.hpp"
#include "support/reference.hpp"

/// Starts from rest against an independent method-of-lines code (tests/support/data/column_transient.json): with and
/// without side walls, both laws, caps from 10 to 1e4 Pa s, seven times, nine depths each.
namespace {

using namespace talus;
using nlohmann::json;

json data() { return support::reference("column_transient.json"); }

column::Parameters parameters_of(const json& reference, int layers) {
  const auto all = data();
  auto par = tests::table_2(reference.at("slope_degrees"), reference.at("thickness"), layers, reference.at("mu_w"));
  par.box.gap = reference.at("gap");
  par.box.gravity = all.at("gravity");
  par.grains = rheology::grains(all.at("grains").at("rho_star"), all.at("grains").at("Phi"), reference.at("d"));
  if (reference.at("law") == "classical") par.law = support::classical_of(reference);
  else par.law = support::partial_of(reference);
  par.wall.u_c = reference.at("u_c");
  par.regularisation = {.eta_max = reference.at("eta_max"), .cap = rheology::Cap::hard};
  par.grid.spacing = grid::Spacing::clustered;
  par.grid.cluster_depth = 0.1 * par.thickness;
  return par;
}

/// What the reference claims of its own error [m/s]: stated; 0.3 of the last difference, as where it is stated; or, on
/// 400 nodes, the difference of the finest two of the capped twin times the square of their ratio of errors, 2.7.
double stated_error(const json& reference, const json& cases) {
  if (reference.contains("error")) return reference.at("error");
  if (reference.contains("difference_1600_800")) return 0.3 * reference.at("difference_1600_800").get<double>();
  const std::string twin = reference.at("name").get<std::string>().substr(0, 2) + "_eta_max_10";
  for (const auto& each : cases)
    if (each.at("name") == twin) return 2.7 * 2.7 * each.at("difference_1600_800").get<double>();
  throw std::runtime_error("no twin of " + twin);
}

class Start : public testing::TestWithParam<json> {};

TEST_P(Start, AgreesWithAnIndependentCodeWithinItsStatedError) {
  const auto& reference = GetParam();
  const auto all = data();
  const double error = stated_error(reference, all.at("cases"));
  const int coarse_layers = 600;
  tests::ColumnRun coarse(parameters_of(reference, coarse_layers), tests::precise()),
      fine(parameters_of(reference, 2 * coarse_layers), tests::precise());
  const auto extrapolated = [](double c, double f) { return f + (f - c) / 3.0; };
  double worst = 0.0, worst_flow = 0.0, last_change = 0.0;
  const double H = reference.at("thickness");
  for (std::size_t i = 0; i < reference.at("times").size(); ++i) {
    const double t = reference.at("times")[i];
    coarse.at(t);
    fine.at(t);
    for (std::size_t j = 0; j < all.at("depths_over_thickness").size(); ++j) {
      const double depth = H * all.at("depths_over_thickness")[j].get<double>();
      const double u = extrapolated(coarse.speed(depth), fine.speed(depth)), expected = reference.at("u")[i][j];
      worst = std::max(worst, std::abs(u - expected));
      last_change = std::max(last_change, std::abs(u - fine.speed(depth)));
      EXPECT_NEAR(u, expected, error) << t << " s, depth " << depth << " m";
    }
    const double flow = extrapolated(coarse.flow(), fine.flow()), expected = reference.at("flow")[i];
    worst_flow = std::max(worst_flow, std::abs(flow - expected));
    EXPECT_NEAR(flow, expected, error * H) << t << " s";
  }
  std::printf(
      "%-16s differs by %.1e m/s and %.1e m2/s, stated %.1e m/s; own extrapolation %.1e m/s; steps %lld, failures of "
      "Newton %lld\n",
      reference.at("name").get<std::string>().c_str(), worst, worst_flow, error, last_change,
      static_cast<long long>(fine.statistics().steps), static_cast<long long>(fine.statistics().newton_failures));
}

INSTANTIATE_TEST_SUITE_P(Column, Start, testing::ValuesIn(data().at("cases").get<std::vector<json>>()),
                         [](const auto& each) { return each.param.at("name").template get<std::string>(); });

}  // namespace
