#pragma once

#include <numbers>

#include "support/manufactured_surface.hpp"

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

/// With friction of side walls.
inline Wave fluid_wave() {
  const double viscosity = 0.05;
  auto par = fluid_box(viscosity, 0, 0);
  par.box.lid.reset();
  par.box.gravity = 4.0;
  par.box.tilt = 0.2;
  par.box.gap = 2.0;
  par.wall = {.mu_w = 0.3, .u_c = 0.5};
  par.grid.cluster_depth = 0.5;
  par.initial.thickness = wave_depth;
  auto medium = medium_in(par);
  medium.viscosity = [=](const Taylor2&, const Taylor2&) { return Taylor2(viscosity); };
  return {wave_flow, wave_surface, medium, false, 0.3, on_grids_of(par)};
}

}  // namespace talus::tests
