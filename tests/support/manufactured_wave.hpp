#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "support/layer_cases.hpp"
#include "support/manufactured_forcing.hpp"
#include "support/table.hpp"

/// A manufactured flow of a fluid under a free surface that moves and bends the grid: a wave H(x, t) that runs along a layer whose
/// base does not slip.
namespace talus::tests {

// Lengths [m], times [s], density 1 kg/m3.
inline constexpr double wave_depth = 1.0, swell = 0.12, wave_number = 2.0 * std::numbers::pi, frequency = 2.0,
                        current = 0.4, churn = 0.15;

inline Taylor2 wave_surface(const Taylor2& x, const Taylor2& t) {
  return wave_depth + swell * cos(wave_number * x - frequency * t);
}

/// u = d psi/dz and w = -d psi/dx of psi = Q g(sigma) + S G(sigma), sigma = z/H: two vortices in a period on a current, all of
/// them with the wave.
inline FlowAt wave_flow(const Taylor2& x, const Taylor2& z, const Taylor2& t) {
  const Taylor2 phase = wave_number * x - frequency * t;
  const Taylor2 H = wave_surface(x, t);
  const Taylor2 H_x = -swell * wave_number * sin(phase);
  // The surface moves with the flow: dH/dt + dQ/dx = 0.
  const Taylor2 Q = current + (frequency / wave_number) * swell * cos(phase);
  const Taylor2 Q_x = -frequency * swell * sin(phase);
  const Taylor2 S = churn * sin(2.0 * wave_number * x + frequency * t);
  const Taylor2 S_x = churn * 2.0 * wave_number * cos(2.0 * wave_number * x + frequency * t);
  const Taylor2 s = z / H, s_x = -(s * H_x) / H;
  // Nothing moves on the base, and psi = Q on the surface.
  const Taylor2 g = s * s * (3.0 - s) / 2.0, g_s = 1.5 * s * (2.0 - s);
  const Taylor2 G = s * s * (1.0 - s), G_s = s * (2.0 - 3.0 * s);
  const Taylor2 u = (Q * g_s + S * G_s) / H;
  const Taylor2 w = -(Q_x * g + S_x * G + (Q * g_s + S * G_s) * s_x);
  const Taylor2 p = 4.0 * (H - z) + 3.0 + 0.5 * sin(wave_number * x) * cos(1.5 * z) * cos(frequency * t);
  return {u, w, p};
}

struct WaveCase {
  std::string name;
  grid::Spacing spacing;
  std::vector<int> cells = {8, 16, 32};
  double order = 1.8;  ///< at least, of u, w, p and H between the last two grids
};
inline void PrintTo(const WaveCase& c, std::ostream* out) { *out << c.name; }

inline layer::Parameters wave_parameters(const WaveCase& c, int n) {
  auto par = fluid_box(0.05, n, n);
  par.box.lid.reset();
  par.box.gravity = 4.0;
  par.box.tilt = 0.2;
  par.box.gap = 2.0;
  par.wall = {.mu_w = 0.3, .u_c = 0.5};
  par.grid.spacing = c.spacing;
  par.grid.cluster_depth = 0.5;
  par.initial.thickness = wave_depth;
  return par;
}

inline void expect_wave_order(const WaveCase& c) {
  const double end = 0.3;
  Table table("layer_manufactured_surface_" + c.name,
              {"cells", "L2 of u [m/s]", "L2 of w [m/s]", "L2 of p [Pa]", "Linf of u [m/s]", "Linf of w [m/s]",
               "Linf of p [Pa]", "Linf of H [m]", "order u", "order w", "order p", "order H", "order Linf p"});
  std::vector<double> h, u, w, p, H, p_most;
  for (const int n : c.cells) {
    auto par = wave_parameters(c, n);
    Medium medium;
    medium.wall_friction = 2.0 * par.wall.mu_w / par.box.gap;
    medium.u_c = par.wall.u_c;
    medium.weight = {par.box.gravity * std::sin(par.box.tilt), -par.box.gravity * std::cos(par.box.tilt)};
    medium.viscosity = [&](const Taylor2&, const Taylor2&) { return Taylor2(par.fluid->eta); };
    const auto forcing = std::make_shared<ManufacturedForcing>(par, wave_flow, medium, wave_surface);
    par.forcing = forcing;
    const layer::Layer system(par);
    const auto exact = [&](double x, double z, double t) { return forcing->exact(x, z, t); };
    auto y = state_at_rest(system);
    for (int i = 0; i < n; ++i) y[system.unknowns().H(i)] = forcing->height(system.columns().x_centre(i), 0.0);
    set_flow(system, exact, 0.0, y);
    integrate(system, 0.0, end, y, 1e-7);
    const auto e = errors(system, exact, end, y);
    double H_most = 0.0;
    for (int i = 0; i < n; ++i)
      H_most =
          std::max(H_most, std::abs(y[system.unknowns().H(i)] - forcing->height(system.columns().x_centre(i), end)));
    h.push_back(1.0 / n), u.push_back(e.u.l2), w.push_back(e.w.l2), p.push_back(e.p.l2), p_most.push_back(e.p.linf);
    H.push_back(H_most);
    const auto order = [&](const std::vector<double>& v) {
      return v.size() == 1 ? Table::Cell("") : diagnostics::observed_orders(h, v).back();
    };
    table.row({double(n), e.u.l2, e.w.l2, e.p.l2, e.u.linf, e.w.linf, e.p.linf, H_most, order(u), order(w), order(p),
               order(H), order(p_most)});
  }
  EXPECT_GT(diagnostics::observed_orders(h, u).back(), c.order);
  EXPECT_GT(diagnostics::observed_orders(h, w).back(), c.order);
  EXPECT_GT(diagnostics::observed_orders(h, H).back(), c.order);
  EXPECT_GT(diagnostics::observed_orders(h, p).back(), c.order);
}

}  // namespace talus::tests
