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

/// The Fourier symbol of the layer's operator about frozen uniform shear, from its exact Jacobian: growth rates of plane waves
/// against the closed form of linear theory, without convection, which that leaves out.
namespace {

using namespace talus;
using Complex = std::complex<double>;
using core::Index;

constexpr double pi = std::numbers::pi;
constexpr double pressure = 100.0;  // [Pa]

/// Amplitudes of the rows (momentum along, momentum across, continuity) that plane waves of (u, omega, p) leave, each of unit
/// amplitude at its own place of the staggered grid.
using Matrix = std::array<std::array<Complex, 3>, 3>;

/// A weightless layer in uniform shear at inertial number I. Rows are read in its middle, where the stencils see neither base nor
/// surface nor ends.
class ShearedLayer {
 public:
  /// Cells are h [m] wide and high.
  ShearedLayer(const rheology::Law& law, double I, double h)
      : layer_(parameters(law, h)), h_(h), shear_(I * std::sqrt(pressure / grains().rho_star) / grains().d) {
    const auto& at = layer_.unknowns();
    std::vector<double> y(layer_.layout().size(), 0.0);
    const std::vector<double> yp(y);
    for (int i = 0; i < n_columns; ++i) {
      for (int k = 0; k < n_layers; ++k) {
        y.at(at.u(i, k)) = shear_ * h * (k - middle);
        y.at(at.p(i, k)) = pressure;
      }
      y.at(at.H(i)) = h * n_layers;
    }
    const auto& pattern = layer_.pattern();
    std::vector<double> stiffness(pattern.n_nonzeros()), both(stiffness);
    layer_.jacobian(0.0, y, yp, 0.0, stiffness);
    layer_.jacobian(0.0, y, yp, 1.0, both);
    const std::array<Index, 3> rows{at.momentum_u(column, middle), at.momentum_w(column, middle),
                                    at.continuity(column, middle)};
    const auto read = [&](int field, Index unknown, double x, double z) {
      for (int row = 0; row < 3; ++row) {
        const Index e = pattern.find(rows[row], unknown);
        if (e >= 0)
          entries_.push_back(
              {row, field, x - places[row][0], z - places[row][1], stiffness[e], both[e] - stiffness[e]});
      }
    };
    for (int i = 0; i < n_columns; ++i) {
      for (int k = 0; k < n_layers; ++k) {
        read(0, at.u(i, k), i, k + 0.5);
        read(1, at.omega(i, k + 1), i + 0.5, k + 1);
        read(2, at.p(i, k), i + 0.5, k + 0.5);
      }
    }
  }

  [[nodiscard]] double shear() const { return shear_; }
  [[nodiscard]] static rheology::Grains grains() { return tests::table_2_grains(); }

  /// Growth rate [1/s] of the one mode without divergence of the wave (kx, kz) [1/m].
  [[nodiscard]] Complex growth(double kx, double kz) const {
    Matrix A{}, M{};
    for (const auto& e : entries_) {
      const Complex wave = std::exp(Complex(0.0, (kx * e.x + kz * e.z) * h_));
      A[e.row][e.field] += e.stiffness * wave;
      M[e.row][e.field] += e.mass * wave;
    }
    const std::array<Complex, 2> flow{A[2][1], -A[2][0]};  // no divergence
    const std::array<Complex, 2> rows{A[1][2], -A[0][2]};  // no pressure
    Complex force = 0.0, inertia = 0.0;
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) {
        force += rows[r] * A[r][c] * flow[c];
        inertia += rows[r] * M[r][c] * flow[c];
      }
    }
    return -force / inertia;
  }

 private:
  static constexpr int n_columns = 9, n_layers = 9, column = 4, middle = 4;
  /// Where the rows stand, in cells.
  static constexpr std::array<std::array<double, 2>, 3> places{
      {{column, middle + 0.5}, {column + 0.5, middle}, {column + 0.5, middle + 0.5}}};

  /// One entry of the Jacobian, at its distance from its row in cells.
  struct Entry {
    int row, field;
    double x, z, stiffness, mass;
  };

  static layer::Parameters parameters(const rheology::Law& law, double h) {
    auto par = tests::periodic_layer(n_columns * h, n_layers * h, 0.0, n_columns, n_layers);
    par.law = law;
    par.box.gravity = 0.0;
    par.numerics.advection = layer::Advection::none;
    par.numerics.film = 1e-3 * h;
    par.grid.cluster_depth = 1e6 * n_layers * h;
    return par;
  }

  layer::Layer layer_;
  double h_, shear_;
  std::vector<Entry> entries_;
};

const std::vector<std::pair<std::string, rheology::Law>>& laws() {
  static const std::vector<std::pair<std::string, rheology::Law>> list{
      {"classical", tests::table_2_classical()},
      {"partial", rheology::partially_regularised(tests::table_2_classical(), 1.3, 1.9, 0.05178)}};
  return list;
}

/// (eta k^2/rho) over the shear rate.
double scale(const rheology::Law& law, double I, double k) {
  return rheology::growth_scale(ShearedLayer::grains(), rheology::response(law, I), I, k);
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
        const ShearedLayer flow(law, I, h.back());
        double squares = 0.0;
        int directions = 0;
        for (int degrees = -60; degrees <= 60; degrees += 15, ++directions) {
          const double angle = degrees * pi / 180.0;
          const Complex sigma = flow.growth(kx, kx * std::tan(angle)) / flow.shear();
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
      const ShearedLayer flow(law, I, h);
      const double kx = 2.0 * pi / (cells * h);
      double most = -1e300, exact = -1e300, at = 0.0;
      for (int n = 1; n <= 3000; ++n) {  // fine enough for the narrow growing band below the pole where q > 1
        const double degrees = 0.02 * n, angle = degrees * pi / 180.0;
        const double sigma =
            flow.growth(kx, kx * std::tan(angle)).real() / flow.shear() / scale(law, I, kx / std::cos(angle));
        if (sigma > most) at = degrees;
        most = std::max(most, sigma);
        exact = std::max(exact, rheology::growth(response, std::sin(2.0 * angle)));
      }
      double anywhere = -1e300;
      for (int m = 1; m < cells / 2; ++m) {
        for (int n = -31; n <= 31; ++n) {
          const Complex sigma = flow.growth(m * kx, n * pi / 32.0 / h) / flow.shear() / scale(law, I, 1.0 / h);
          anywhere = std::max(anywhere, sigma.real());
        }
      }
      table.row({name, I, most, exact, at, anywhere});
      EXPECT_EQ(most > 0.0, rheology::max_growth(response) > 0.0) << name << ", I " << I;
      EXPECT_EQ(exact > 0.0, rheology::max_growth(response) > 0.0) << name << ", I " << I;
      EXPECT_EQ(anywhere > 0.0, rheology::max_growth(response) > 0.0) << name << ", I " << I;
    }
  }
}

}  // namespace
