#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "rheology/well_posedness.hpp"
#include "support/layer_cases.hpp"
#include "support/table.hpp"
#include "symbol/growth_map.hpp"
#include "symbol/sheared_layer.hpp"
#include "symbol/staggered_symbol.hpp"

/// The Fourier symbol of the layer's operator about frozen uniform shear, from its exact Jacobian: growth rates of plane waves
/// against the closed form of linear theory, without convection, which that leaves out.
namespace {

using namespace talus;
using Complex = std::complex<double>;
using symbol::ShearedLayer;

constexpr double pi = std::numbers::pi;

const std::vector<std::pair<std::string, rheology::Law>>& laws() {
  static const std::vector<std::pair<std::string, rheology::Law>> list{
      {"classical", tests::table_2_classical()},
      {"partial", rheology::partially_regularised(tests::table_2_classical(), 1.3, 1.9, 0.05178)}};
  return list;
}

/// (eta k^2/rho) over the shear rate.
double scale(const rheology::Law& law, double I, double k) {
  return rheology::growth_scale(tests::table_2_grains(), rheology::response(law, I), I, k);
}

TEST(LayerSymbol, ConvergesToTheClosedFormAtSecondOrder) {
  const double wavelength = 0.02, kx = 2.0 * pi / wavelength;
  tests::Table table("layer_symbol_order", {"law", "I", "cells a wave", "error over eta k2/rho", "order"});
  for (const auto& [name, law] : laws()) {
    for (const double I : {1e-3, 2e-3, 0.02, 0.1, 0.5, 1.0}) {
      const auto response = rheology::response(law, I);
      std::vector<double> h, e;
      for (const int cells : {8, 16, 32, 64}) {
        h.push_back(wavelength / cells);
        const ShearedLayer flow(tests::table_2_grains(), law, I, h.back());
        double squares = 0.0;
        int directions = 0;
        for (int degrees = -60; degrees <= 60; degrees += 15, ++directions) {
          const double angle = degrees * pi / 180.0;
          const Complex sigma = flow.growth(kx * h.back(), kx * std::tan(angle) * h.back()) / flow.shear();
          const double exact = rheology::growth(response, std::sin(2.0 * angle));
          squares += std::norm(sigma / scale(law, I, kx / std::cos(angle)) - exact);
        }
        e.push_back(std::sqrt(squares / directions));
        table.row({name, I, double(cells), e.back(),
                   e.size() == 1 ? tests::Table::Cell("") : diagnostics::observed_orders(h, e).back()});
      }
      EXPECT_NEAR(diagnostics::observed_orders(h, e).back(), 2.0, 0.1) << name << ", I " << I;
      EXPECT_LT(e.back(), 5e-3) << name << ", I " << I;
    }
  }
}

TEST(LayerSymbol, GrowsWhereTheLawIsIllPosedAndDecaysWhereItIsNot) {
  tests::Table table("layer_symbol_sign", {"law", "I", "most growth", "exact", "at degrees", "most, all grid waves"});
  const int cells = 32;
  const double h = 1e-3;
  for (const auto& [name, law] : laws()) {
    for (const double I : {1e-3, 2e-3, 0.02, 0.1, 0.5, 1.0, 20.0}) {
      const auto response = rheology::response(law, I);
      const ShearedLayer flow(tests::table_2_grains(), law, I, h);
      const double kx = 2.0 * pi / (cells * h);
      double most = -1e300, exact = -1e300, at = 0.0;
      for (int n = 1; n <= 3000; ++n) {  // fine enough for the narrow growing band below the pole where q > 1
        const double degrees = 0.02 * n, angle = degrees * pi / 180.0;
        const double sigma =
            flow.growth(kx * h, kx * std::tan(angle) * h).real() / flow.shear() / scale(law, I, kx / std::cos(angle));
        if (sigma > most) at = degrees;
        most = std::max(most, sigma);
        exact = std::max(exact, rheology::growth(response, std::sin(2.0 * angle)));
      }
      const auto waves =
          symbol::fastest_waves([&](double x, double z) { return flow.growth(x, z).real(); }, std::vector<int>{cells});
      const double anywhere = waves.back().growth / flow.shear() / scale(law, I, 1.0 / h);
      table.row({name, I, most, exact, at, anywhere});
      EXPECT_EQ(most > 0.0, rheology::max_growth(response) > 0.0) << name << ", I " << I;
      EXPECT_EQ(exact > 0.0, rheology::max_growth(response) > 0.0) << name << ", I " << I;
      EXPECT_EQ(anywhere > 0.0, rheology::max_growth(response) > 0.0) << name << ", I " << I;
    }
  }
}

/// The textbook grid: long waves follow the closed form at second order with either viscosity, and direct viscosity grows where the law
/// is ill-posed; the average of cells hides it from the grid's shortest waves.
TEST(StaggeredSymbol, ConvergesToTheClosedFormAtSecondOrder) {
  using symbol::CornerViscosity;
  for (const auto& [name, law] : laws()) {
    for (const double I : {1e-3, 0.1, 1.0}) {
      const auto response = rheology::response(law, I);
      for (const auto viscosity : {CornerViscosity::direct, CornerViscosity::averaged}) {
        std::vector<double> h, e;
        for (const int cells : {16, 32, 64}) {
          const double phase = 2.0 * pi / cells;
          double squares = 0.0;
          for (int degrees = -60; degrees <= 60; degrees += 15) {
            const double angle = degrees * pi / 180.0, phase_z = phase * std::tan(angle);
            const double square = phase * phase / std::pow(std::cos(angle), 2);
            squares += std::pow(symbol::staggered_growth(response, viscosity, phase, phase_z) / square -
                                    rheology::growth(response, std::sin(2.0 * angle)),
                                2);
          }
          h.push_back(1.0 / cells);
          e.push_back(std::sqrt(squares / 9.0));
        }
        EXPECT_NEAR(diagnostics::observed_orders(h, e).back(), 2.0, 0.1) << name << ", I " << I;
        EXPECT_LT(e.back(), 0.02) << name << ", I " << I;
      }
    }
  }
}

TEST(StaggeredSymbol, AveragesHideWhatShortWavesWouldShow) {
  using symbol::CornerViscosity;
  const auto response = rheology::response(laws().front().second, 1e-3);
  const std::vector<int> sizes{32, 64, 128};
  std::array<std::vector<symbol::FastestWave>, 2> fastest;
  for (const auto viscosity : {CornerViscosity::direct, CornerViscosity::averaged})
    fastest.at(static_cast<std::size_t>(viscosity)) = symbol::fastest_waves(
        [&](double x, double z) { return symbol::staggered_growth(response, viscosity, x, z); }, sizes);
  ASSERT_GT(rheology::max_growth(response), 0.0);
  for (const auto& direct : fastest[0]) EXPECT_GT(direct.growth, 0.0);
  EXPECT_LT(fastest[1][0].growth, 0.0) << "averaged, 32 cells: hidden";
  EXPECT_LT(fastest[1][1].growth, 0.0) << "averaged, 64 cells: hidden";
  EXPECT_LT(fastest[1][2].growth, 0.1 * fastest[0][2].growth) << "averaged, 128 cells: hardly seen";
}

/// The wave of two cells along x and none across moves no momentum across layers on this grid: it has no rate.
TEST(LayerSymbol, AWaveWithoutInertiaHasNoRate) {
  const ShearedLayer flow(tests::table_2_grains(), laws().back().second, 0.5, 1e-3);
  EXPECT_TRUE(std::isnan(flow.growth(pi, 0.0).real()));
  EXPECT_LT(flow.growth(0.999 * pi, 0.0).real(), 0.0);
  EXPECT_LT(flow.growth(pi, 0.1).real(), 0.0);
}

TEST(FastestWaves, LooksAtEachWaveOfEachGrid) {
  const std::vector<int> sizes{2, 8};
  std::vector<std::pair<double, double>> seen;
  const auto record = [&](double x, double z) {
    seen.emplace_back(x, z);
    return std::abs(x - 0.5 * pi) + std::abs(z - 0.25 * pi) < 1e-12 ? 1.0 : -x;
  };
  const auto fastest = symbol::fastest_waves(record, sizes);
  EXPECT_EQ(seen.size(), 4U * 8U);
  EXPECT_EQ(fastest[1].growth, 1.0);
  EXPECT_NEAR(fastest[1].phase_x, 0.5 * pi, 1e-12);
  EXPECT_NEAR(fastest[0].growth, -pi, 1e-12) << "of two cells there is one wave length";
  EXPECT_THROW((void)symbol::fastest_waves(record, std::vector<int>{12}), std::invalid_argument);
}

}  // namespace
