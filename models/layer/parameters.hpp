#pragma once

#include <limits>

#include "rheology/law.hpp"
#include "rheology/viscosity.hpp"

namespace talus::layer {

/// The box between the side walls, seen along the base: x down the base from the left end, z normal to it.
struct Box {
  double length;            ///< along the base [m]
  double height;            ///< normal to the base; the inlet lies there [m]
  double tilt;              ///< of the base against the horizontal, theta [rad]; positive: down to the right
  double gap;               ///< between the side walls, W [m]
  double gravity;           ///< g [m/s2]
  bool periodic = false;    ///< the right end continues at the left end
  bool left_open = true;    ///< not periodic: grains may leave over the left end; else a wall
  double base_slope = 0.0;  ///< db/dx of the base against the grid's x axis [1]; the column lines stay normal to x
};

/// Grains poured from the inlet: a column source of mass, smooth in time.
struct Inflow {
  double rate = 0.0;      ///< Q [kg/s]
  double position = 0.0;  ///< centre of the inlet along x at z = box height [m]
  double width = 0.0;     ///< standard deviation sigma of the jet's footprint along x [m]
  double start = 0.0;     ///< [s]
  double stop = std::numeric_limits<double>::infinity();  ///< [s]
  double ramp = 0.2;                                      ///< duration of the C2 ramp that follows start and stop [s]
  bool along_gravity = true;                              ///< the jet falls along gravity from the inlet; else along -z
  bool momentum = false;  ///< the jet brings the momentum of its free fall; else the speed of the grains it meets
};

struct Wall {
  double mu_w;  ///< side-wall friction [1]
  double u_c;   ///< speed at which wall friction turns on, tanh(|u| / u_c) [m/s]
};

/// Cells: uniform columns; layers clustered under the surface by depth D(s) = H0 ((1 + H/H0)^s - 1).
struct Grid {
  int columns;
  int layers;
  double cluster_depth;  ///< H0 [m]: layers are uniform where the heap is much thinner, geometric where much deeper
};

enum class Advection { none, upwind, central };

/// Numerical devices, each named, each with its place of action in the output.
struct Numerics {
  Advection advection = Advection::upwind;
  double film = 5e-4;  ///< Hs: the immobile part of a film on the base [m]
  double film_blend =
      4.0;  ///< the donor flux of thin films fades out between 1 and this many film thicknesses above Hs [1]
  double jump_from =
      0.04;               ///< the donor flux also enters where the thickness changes by more than this share of itself
  double jump_to = 0.12;  ///< between two columns (outlet, fronts), and is alone beyond this share [1]
  double film_speed = 1e-5;  ///< speed scale e of the smooth donor switch [m/s]
};

struct Initial {
  double thickness;  ///< H at the start [m], everywhere
};

/// All that the layer model needs to know.
struct Parameters {
  Box box;
  rheology::Grains grains;
  rheology::Law law;
  rheology::Regularisation regularisation;
  Wall wall;
  Inflow inflow;
  Grid grid;
  Numerics numerics;
  Initial initial;
  double atol_velocity = 1e-5;  ///< [m/s]
  double atol_pressure = 0.1;   ///< [Pa]
  double atol_height = 1e-6;    ///< [m]
  double atol_mass = 1e-5;      ///< of the budgets [kg]
};

}  // namespace talus::layer
