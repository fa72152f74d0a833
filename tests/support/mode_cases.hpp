#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinsol/kinsol.hpp"
#include "modes/plane_waves.hpp"
#include "steady/bagnold.hpp"
#include "support/layer_cases.hpp"
#include "support/layer_flow.hpp"
#include "support/reference.hpp"
#include "support/table.hpp"

/// Leading modes of the layer under a lid about its discrete steady states, row by row of stability.json.
namespace talus::tests {

using nlohmann::json;

inline constexpr int n_mode_columns = 9;  // rows reach four columns at most: a ring this long tells neighbours apart

inline rheology::Law law_of(const json& data, const json& row) {
  const auto& parameters = data.at("parameters").at(row.at("table").get<std::string>());
  if (row.at("law") == "classical") return support::classical_of(parameters);
  return support::partial_of(parameters);
}

/// Under a lid, with second-order convection, cells `across` high and wide, nothing regularised.
inline layer::Parameters between_walls(const json& data, const json& row, double thickness, int layers) {
  const double across = thickness / layers;
  auto par = periodic_layer(n_mode_columns * across, thickness, 0.0, n_mode_columns, layers);
  const auto& parameters = data.at("parameters").at(row.at("table").get<std::string>());
  par.grains = support::grains_of(parameters);
  par.law = law_of(data, row);
  par.numerics.advection = layer::Advection::central;
  par.numerics.film = 1e-3 * across;
  return par;
}

inline double leading_rate(const layer::Layer& system, std::span<const double> y, double k) {
  const modes::PlaneWaves waves(system, 0.0, y, n_mode_columns);
  const auto all = waves.modes(k * system.columns().dx());
  EXPECT_LT(all.front().residual, 1e-8);
  return all.front().rate.real();
}

/// Simple shear of rate 1 between walls a length 1 apart.
inline double couette(const json& data, const json& row, int layers) {
  auto par = between_walls(data, row, 1.0, layers);
  par.box.gravity = 0.0;
  par.grains.d = row.at("d");
  const double I = row.at("I"), pressure = par.grains.rho_star * std::pow(par.grains.d / I, 2);
  par.box.lid = experiment::Lid{.speed = 1.0, .pressure = pressure};
  const layer::Layer system(par);
  auto y = state_at_rest(system);
  set_flow(
      system,
      [&](double, double z, double) {
        return PointFlow{z, 0.0, pressure};
      },
      0.0, y);
  std::vector<double> r(y.size()), still(y.size(), 0.0);
  system.residual(0.0, y, still, r);
  for (const double left : r) EXPECT_LT(std::abs(left), 1e-9 * pressure) << "simple shear is steady on any grid";
  return leading_rate(system, y, row.at("k"));
}

/// Bagnold's flow under a lid a tenth below its surface that moves with it.
inline double bagnold(const json& data, const json& row, int layers) {
  const double h = row.at("h"), zeta = row.at("zeta_deg").get<double>() * std::numbers::pi / 180.0;
  auto par = between_walls(data, row, 0.9 * h, layers);
  par.box.tilt = zeta;
  const steady::Channel channel{
      .grains = par.grains, .law = par.law, .gap = 1.0, .mu_w = 0.0, .gravity = par.box.gravity};
  const auto exact = steady::BagnoldFlow::at(channel, zeta, h);
  EXPECT_NEAR(exact->inertial_number(), row.at("I").get<double>(), 1e-8);
  const auto pressure = [&](double z) { return par.grains.rho() * par.box.gravity * std::cos(zeta) * (h - z); };
  par.box.lid = experiment::Lid{.speed = exact->speed(-0.1 * h), .pressure = pressure(0.9 * h)};
  const layer::Layer system(par);
  auto y = state_at_rest(system);
  set_flow(
      system,
      [&](double, double z, double) {
        return PointFlow{exact->speed(z - h), 0.0, pressure(z)};
      },
      0.0, y);
  kinsol::Options options;
  options.rtol = 1e-8;
  kinsol::Kinsol steady(system, options);
  core::Observer nobody;
  steady.start(0.0, y, std::vector<double>(y.size(), 0.0));
  steady.advance(1.0, nobody);
  return leading_rate(system, steady.current().y, row.at("k_h").get<double>() / h);
}

/// From two grids, by their second order.
inline double extrapolated(double coarse, double fine) { return fine + (fine - coarse) / 3.0; }

/// Waves that lean as narrowly as the growing ones of I = 0.02 need more layers than others.
inline bool needs_fine_grid(const json& row) {
  const double k_h = row.value("k_h", 0.0);
  return row.at("I") < 0.05 || k_h > 15.0 || (row.at("I") > 0.4 && row.at("I") < 0.5 && k_h > 1.5) ||
         (row.at("law") == "classical" && row.at("I") == 1.0);
}

/// Of those, waves whose rates 256 layers do not give to a per cent either: their errors must still fall.
inline bool needs_more_than_256_layers(const json& row) {
  const double I = row.at("I"), k_h = row.value("k_h", 0.0), k = row.value("k", 0.0);
  const bool is_classical = row.at("law") == "classical", is_table_1 = row.at("table") == "table_1";
  if (k > 0.0) return k == 5.0 && (I == 1.0 || (I < 0.05 && !(is_table_1 && is_classical)));
  return (k_h == 5.0 && I < 0.05) || k_h == 10.0 || (k_h == 20.0 && I > 0.4 && I < 0.5);
}

template <class Rate>
void compare(const char* name, const json& rows, const char* wave_number, int layers, bool fine_rows,
             const Rate& rate) {
  Table table(name, {"law", "I", "k", "exact", "coarse", "fine", "extrapolated", "off %"});
  for (const auto& row : rows) {
    if (needs_fine_grid(row) != fine_rows) continue;
    const double exact = row.at("rate"), coarse = rate(row, layers / 2), fine = rate(row, layers);
    const double limit = extrapolated(coarse, fine), off = 100.0 * std::abs(limit / exact - 1.0);
    table.row({row.at("law").template get<std::string>(), row.at("I").template get<double>(),
               row.at(wave_number).template get<double>(), exact, coarse, fine, limit, off});
    if (fine_rows && needs_more_than_256_layers(row))
      EXPECT_LT(std::abs(fine - exact), 0.7 * std::abs(coarse - exact)) << row;
    else EXPECT_LT(off, 1.0) << row;
  }
}

}  // namespace talus::tests
