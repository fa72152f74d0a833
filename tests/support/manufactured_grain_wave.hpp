#pragma once

#include <numbers>

#include "support/manufactured_surface.hpp"

/// A manufactured flow of mu(I) grains: a bump H(x, t) that the grains on the surface carry along, over a layer that shears as Bagnold's.
/// On the surface the strain rate is zero and grows as the square root of the depth below, so that I is finite and well-posed
/// all through.
namespace talus::tests {

// Lengths [m], times [s], density 1 kg/m3.
struct GrainWave {
  static constexpr double depth = 1.0, swell = 0.06, length = 3.0, speed = 2.5, churn = 0.02, gravity = 1.0, tilt = 0.4,
                          pressing = 0.05;
  static constexpr double k = 2.0 * std::numbers::pi / length, omega = k * speed;
};

inline Taylor2 grain_surface(const Taylor2& x, const Taylor2& t) {
  using W = GrainWave;
  return W::depth + W::swell * cos(W::k * x - W::omega * t);
}

/// u = d psi/dz and w = -d psi/dx of psi = c z - E + A s^(5/2) + C s^(7/2) + S s^(9/2), s = 1 - z/H: psi and u are zero on the base, and
/// on the surface grains move with the wave, u = c and w = 0, without a strain rate. C and S are zero under a level surface.
/// Above, where a surface that is in error may be asked for, all moves with the wave.
inline FlowAt grain_flow(const Taylor2& x, const Taylor2& z, const Taylor2& t) {
  using W = GrainWave;
  const double c = W::speed, E = 0.4 * c * W::depth;
  const Taylor2 phase = W::k * x - W::omega * t, other = W::k * x + W::omega * t;
  const Taylor2 H = grain_surface(x, t), H_x = -W::swell * W::k * sin(phase);
  const Taylor2 S = W::churn * sin(other), S_x = W::churn * W::k * cos(other);
  const Taylor2 A = 3.5 * E - c * H + S, A_x = S_x - c * H_x;
  const Taylor2 C = c * H - 2.5 * E - 2.0 * S, C_x = c * H_x - 2.0 * S_x;
  Taylor2 s = 1.0 - z / H;
  if (s.value < 0.0) s = 0.0;
  const Taylor2 s_x = z * H_x / (H * H);
  const Taylor2 psi_s = 2.5 * A * pow(s, 1.5) + 3.5 * C * pow(s, 2.5) + 4.5 * S * pow(s, 3.5);
  const Taylor2 p = W::gravity * std::cos(W::tilt) * (H - z) * (1.0 + W::pressing * sin(other));
  return {c - psi_s / H, -(A_x * pow(s, 2.5) + C_x * pow(s, 3.5) + S_x * pow(s, 4.5) + psi_s * s_x), p};
}

/// Over a third of a period, with walls of friction mu_w.
inline Wave grain_wave(double mu_w) {
  using W = GrainWave;
  auto par = fluid_box(0.0, 0, 0);
  par.fluid.reset();
  par.box.lid.reset();
  par.box.length = W::length;
  par.box.height = 10.0 * W::depth;
  par.box.gravity = W::gravity;
  par.box.tilt = W::tilt;
  par.box.gap = 2.0;
  par.grains = rheology::grains(2.0, 0.5, 0.05);
  par.law = table_2_partial();
  par.wall = {.mu_w = mu_w, .u_c = 0.5};
  par.grid.cluster_depth = 0.5;
  par.initial.thickness = W::depth;
  auto medium = medium_in(par);
  medium.viscosity = grain_viscosity(table_2_partial(), par.grains);
  return {grain_flow, grain_surface, medium, true, W::length / W::speed / 3.0, on_grids_of(par)};
}

}  // namespace talus::tests
