#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/layer_cases.hpp"
#include "support/manufactured_forcing.hpp"
#include "support/table.hpp"

/// Manufactured flows under a free surface that moves and bends the grid, and the orders at which the layer model finds them.
namespace talus::tests {

/// A wave H(x, t) along a layer whose base does not slip, in a box whose ends are joined.
struct Wave {
  Flow flow;
  ManufacturedForcing::Surface surface;
  Medium medium;
  bool bare;   ///< neither traction nor pressure on the surface, so that none is given to it
  double end;  ///< of the run from t = 0 [s]
  std::function<layer::Parameters(int n)> parameters;  ///< n cells a side
};

inline std::function<layer::Parameters(int n)> on_grids_of(const layer::Parameters& par) {
  return [=](int n) {
    auto with = par;
    with.grid.columns = with.grid.layers = n;
    return with;
  };
}

/// Density, weight and wall friction of a scene; viscosity is still to be given.
inline Medium medium_in(const layer::Parameters& par) {
  Medium medium;
  medium.rho = par.grains.rho();
  medium.weight = {medium.rho * par.box.gravity * std::sin(par.box.tilt),
                   -medium.rho * par.box.gravity * std::cos(par.box.tilt)};
  medium.wall_friction = 2.0 * par.wall.mu_w / par.box.gap;
  medium.u_c = par.wall.u_c;
  return medium;
}

/// On a surface without traction: that of grains, whose stress, 0/0 there, has no value in arithmetic.
class BareForcing final : public ManufacturedForcing {
 public:
  using ManufacturedForcing::ManufacturedForcing;
  [[nodiscard]] double surface_pressure(int /*i*/, double /*t*/) const override { return 0.0; }
  [[nodiscard]] layer::Vector surface_pull(int /*f*/, double /*t*/) const override { return {0.0, 0.0}; }
};

struct WaveCase {
  std::string name;
  grid::Spacing spacing;
  std::vector<int> cells = {8, 16, 32};
  /// Least orders between the last two grids: in L2 of u, w, p and H; in Linf of u, of p.
  double order, order_u_most, order_p_most;
};
inline void PrintTo(const WaveCase& c, std::ostream* out) { *out << c.name; }

struct WaveErrors {
  enum Field { u, w, p, H };
  static constexpr std::array names = {"u [m/s]", "w [m/s]", "p [Pa]", "H [m]"};
  std::array<diagnostics::Norms, 4> norms;
};

/// At the end of a run with n cells a side.
inline WaveErrors wave_errors(const Wave& wave, grid::Spacing spacing, int n) {
  auto par = wave.parameters(n);
  par.grid.spacing = spacing;
  std::shared_ptr<ManufacturedForcing> forcing;
  if (wave.bare) {
    forcing = std::make_shared<BareForcing>(par, wave.flow, wave.medium, wave.surface);
  } else {
    forcing = std::make_shared<ManufacturedForcing>(par, wave.flow, wave.medium, wave.surface);
  }
  par.forcing = forcing;
  const layer::Layer system(par);
  const auto& columns = system.columns();
  const auto exact = [&](double x, double z, double t) { return forcing->exact(x, z, t); };
  const auto height = [&](int i, double t) { return forcing->height(columns.x_centre(i), t); };
  auto y = state_at_rest(system);
  for (int i = 0; i < n; ++i) y[system.unknowns().H(i)] = height(i, 0.0);
  set_flow(system, exact, 0.0, y);
  integrate(system, 0.0, wave.end, y, 1e-7);
  std::vector<double> H(n);
  for (int i = 0; i < n; ++i) H[i] = y[system.unknowns().H(i)] - height(i, wave.end);
  const auto e = errors(system, exact, wave.end, y);
  return {{e.u, e.w, e.p, diagnostics::norms(H)}};
}

inline void expect_wave_order(const std::string& table_name, const Wave& wave, const WaveCase& c) {
  using diagnostics::Norms;
  Table table(table_name + "_" + c.name,
              {"cells", "error of", "L1", "L2", "Linf", "order L1", "order L2", "order Linf"});
  WaveErrors coarse, fine;
  double ratio = 0.0;
  const auto order = [&](int field, double Norms::*norm) {
    return std::log(coarse.norms[field].*norm / fine.norms[field].*norm) / std::log(ratio);
  };
  for (std::size_t g = 0; g < c.cells.size(); ++g) {
    coarse = std::exchange(fine, wave_errors(wave, c.spacing, c.cells[g]));
    if (g > 0) ratio = double(c.cells[g]) / c.cells[g - 1];
    for (int field = 0; field < 4; ++field) {
      const auto& e = fine.norms[field];
      const auto cell = [&](double Norms::*norm) { return g == 0 ? Table::Cell("") : order(field, norm); };
      table.row({double(c.cells[g]), WaveErrors::names[field], e.l1, e.l2, e.linf, cell(&Norms::l1), cell(&Norms::l2),
                 cell(&Norms::linf)});
    }
  }
  for (int field = 0; field < 4; ++field) EXPECT_GT(order(field, &Norms::l2), c.order) << WaveErrors::names[field];
  EXPECT_GT(order(WaveErrors::u, &Norms::linf), c.order_u_most);
  EXPECT_GT(order(WaveErrors::p, &Norms::linf), c.order_p_most);
}

}  // namespace talus::tests
