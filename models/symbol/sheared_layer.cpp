#include "symbol/sheared_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "layer/layer.hpp"

namespace talus::symbol {
namespace {

using Complex = ShearedLayer::Complex;
using core::Index;
/// Amplitudes of the rows (momentum along, momentum across, continuity) that plane waves of (u, omega, p) leave, each of unit
/// amplitude at its own place of the staggered grid.
using Matrix = std::array<std::array<Complex, 3>, 3>;

constexpr double pressure = 100.0;  // [Pa]
constexpr int n_columns = 9, n_layers = 9, column = 4, middle = 4;
constexpr int reach = 2 * n_columns;  // of the stencil, in half cells, at most
/// Where the rows stand, in half cells.
constexpr std::array<std::array<int, 2>, 3> places{
    {{2 * column, 2 * middle + 1}, {2 * column + 1, 2 * middle}, {2 * column + 1, 2 * middle + 1}}};

layer::Parameters parameters(const rheology::Grains& grains, const rheology::Law& law, double h) {
  return {.box = {.length = n_columns * h,
                  .height = 10.0 * n_layers * h,
                  .tilt = 0.0,
                  .gap = 1.0,
                  .gravity = 0.0,
                  .periodic = true},
          .grains = grains,
          .law = law,
          .regularisation = {},
          .wall = {.mu_w = 0.0, .u_c = 1.0},
          .inflow = {},
          .grid = {.columns = n_columns,
                   .layers = n_layers,
                   .cluster_depth = n_layers * h,
                   .spacing = grid::Spacing::uniform},
          .numerics = {.advection = layer::Advection::none, .film = 1e-3 * h},
          .initial = {n_layers * h}};
}

/// e^(i n phase/2) for n from -reach to reach.
std::array<Complex, 2 * reach + 1> powers(double phase) {
  std::array<Complex, 2 * reach + 1> all;
  for (int n = -reach; n <= reach; ++n) all.at(n + reach) = std::polar(1.0, 0.5 * n * phase);
  return all;
}

}  // namespace

ShearedLayer::ShearedLayer(const rheology::Grains& grains, const rheology::Law& law, double I, double h)
    : shear_(I * std::sqrt(pressure / grains.rho_star) / grains.d) {
  if (!(I > 0.0 && h > 0.0)) throw std::invalid_argument("sheared layer: expected I and h above 0");
  const layer::Layer system(parameters(grains, law, h));
  const auto& at = system.unknowns();
  std::vector<double> y(system.layout().size(), 0.0);
  const std::vector<double> yp(y);
  for (int i = 0; i < n_columns; ++i) {
    for (int k = 0; k < n_layers; ++k) {
      y.at(at.u(i, k)) = shear_ * h * (k - middle);
      y.at(at.p(i, k)) = pressure;
    }
    y.at(at.H(i)) = h * n_layers;
  }
  const auto& pattern = system.pattern();
  std::vector<double> stiffness(pattern.n_nonzeros()), both(stiffness);
  system.jacobian(0.0, y, yp, 0.0, stiffness);
  system.jacobian(0.0, y, yp, 1.0, both);
  const std::array<Index, 3> rows{at.momentum_u(column, middle), at.momentum_w(column, middle),
                                  at.continuity(column, middle)};
  const auto read = [&](int field, Index unknown, int x, int z) {
    for (int row = 0; row < 3; ++row) {
      const Index e = pattern.find(rows.at(row), unknown);
      if (e >= 0)
        entries_.push_back(
            {row, field, x - places.at(row)[0], z - places.at(row)[1], stiffness[e], both[e] - stiffness[e]});
    }
  };
  for (int i = 0; i < n_columns; ++i) {
    for (int k = 0; k < n_layers; ++k) {
      read(0, at.u(i, k), 2 * i, 2 * k + 1);
      read(1, at.omega(i, k + 1), 2 * i + 1, 2 * (k + 1));
      read(2, at.p(i, k), 2 * i + 1, 2 * k + 1);
    }
  }
  for (const auto& e : entries_) mass_ = std::max(mass_, std::abs(e.mass));
}

Complex ShearedLayer::growth(double phase_x, double phase_z) const {
  const auto along = powers(phase_x), across = powers(phase_z);
  Matrix A{}, M{};
  for (const auto& e : entries_) {
    const Complex wave = along.at(e.x + reach) * across.at(e.z + reach);
    A.at(e.row).at(e.field) += e.stiffness * wave;
    M.at(e.row).at(e.field) += e.mass * wave;
  }
  const std::array<Complex, 2> flow{A[2][1], -A[2][0]};  // no divergence
  const std::array<Complex, 2> rows{A[1][2], -A[0][2]};  // no pressure
  Complex force = 0.0, inertia = 0.0;
  double size = 0.0;
  for (int r = 0; r < 2; ++r) {
    for (int c = 0; c < 2; ++c) {
      force += rows.at(r) * A.at(r).at(c) * flow.at(c);
      inertia += rows.at(r) * M.at(r).at(c) * flow.at(c);
      size += std::abs(rows.at(r)) * std::abs(flow.at(c));
    }
  }
  constexpr double rounding = 1e-13;
  if (std::abs(inertia) <= rounding * size * mass_) return std::numeric_limits<double>::quiet_NaN();
  return -force / inertia;
}

}  // namespace talus::symbol
