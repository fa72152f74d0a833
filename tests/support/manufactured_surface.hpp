#pragma once

#include <gtest/gtest.h>

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
  double order = 1.8;                             ///< at least, in L2, of u, w, p and H between the last two grids
  double order_u_most = 0.0, order_p_most = 0.0;  ///< the same in Linf
};
inline void PrintTo(const WaveCase& c, std::ostream* out) { *out << c.name; }

/// Errors of u, w, p and H at the end of a run with n cells a side.
inline std::vector<std::pair<const char*, diagnostics::Norms>> wave_errors(const Wave& wave, grid::Spacing spacing,
                                                                           int n) {
  auto par = wave.parameters(n);
  par.grid.spacing = spacing;
  std::shared_ptr<ManufacturedForcing> forcing;
  if (wave.bare) forcing = std::make_shared<BareForcing>(par, wave.flow, wave.medium, wave.surface);
  else forcing = std::make_shared<ManufacturedForcing>(par, wave.flow, wave.medium, wave.surface);
  par.forcing = forcing;
  const layer::Layer system(par);
  const auto exact = [&](double x, double z, double t) { return forcing->exact(x, z, t); };
  auto y = state_at_rest(system);
  for (int i = 0; i < n; ++i) y[system.unknowns().H(i)] = forcing->height(system.columns().x_centre(i), 0.0);
  set_flow(system, exact, 0.0, y);
  integrate(system, 0.0, wave.end, y, 1e-7);
  const auto e = errors(system, exact, wave.end, y);
  std::vector<double> H(n);
  for (int i = 0; i < n; ++i)
    H[i] = y[system.unknowns().H(i)] - forcing->height(system.columns().x_centre(i), wave.end);
  return {{"u [m/s]", e.u}, {"w [m/s]", e.w}, {"p [Pa]", e.p}, {"H [m]", diagnostics::norms(H)}};
}

inline void expect_wave_order(const std::string& table_name, const Wave& wave, const WaveCase& c) {
  Table table(table_name + "_" + c.name,
              {"cells", "error of", "L1", "L2", "Linf", "order L1", "order L2", "order Linf"});
  std::vector<std::pair<const char*, diagnostics::Norms>> coarse, fine;
  const auto order = [&](int field, double diagnostics::Norms::*norm, double ratio) {
    return std::log(coarse[field].second.*norm / fine[field].second.*norm) / std::log(ratio);
  };
  for (std::size_t g = 0; g < c.cells.size(); ++g) {
    coarse = std::exchange(fine, wave_errors(wave, c.spacing, c.cells[g]));
    for (int field = 0; field < 4; ++field) {
      const auto& [name, e] = fine[field];
      const auto cell = [&](double diagnostics::Norms::*norm) {
        return g == 0 ? Table::Cell("") : order(field, norm, double(c.cells[g]) / c.cells[g - 1]);
      };
      table.row({double(c.cells[g]), name, e.l1, e.l2, e.linf, cell(&diagnostics::Norms::l1),
                 cell(&diagnostics::Norms::l2), cell(&diagnostics::Norms::linf)});
    }
  }
  const double ratio = double(c.cells.back()) / c.cells[c.cells.size() - 2];
  for (int field = 0; field < 4; ++field)
    EXPECT_GT(order(field, &diagnostics::Norms::l2, ratio), c.order) << fine[field].first;
  EXPECT_GT(order(0, &diagnostics::Norms::linf, ratio), c.order_u_most);
  EXPECT_GT(order(2, &diagnostics::Norms::linf, ratio), c.order_p_most);
}

}  // namespace talus::tests
