#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "experiment/experiment.hpp"
#include "grid/layering.hpp"
#include "layer/disturbance.hpp"
#include "layer/forcing.hpp"
#include "rheology/law.hpp"
#include "rheology/newtonian.hpp"
#include "rheology/viscosity.hpp"

namespace talus::layer {

using experiment::Box;
using experiment::Contact;
using experiment::Inflow;
using experiment::Wall;

/// Cells: uniform columns; layers as grid::Layering.
struct Grid {
  int columns;
  int layers;
  double cluster_depth;  ///< H0 of grid::Layering [m]
  grid::Spacing spacing = grid::Spacing::clustered;
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
  double thickness;                          ///< H at the start [m], everywhere
  std::vector<double> speeds{};              ///< down the base in each layer, from the base up [m/s]; empty: rest
  std::optional<Disturbance> disturbance{};  ///< of these speeds
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
  double atol_velocity = 1e-5;                       ///< [m/s]
  double atol_pressure = 0.1;                        ///< [Pa]
  double atol_height = 1e-6;                         ///< [m]
  double atol_mass = 1e-5;                           ///< of the budgets [kg]
  std::optional<rheology::Newtonian> fluid = {};     ///< in place of grains: law and regularisation are not read
  std::shared_ptr<const Forcing> forcing = nullptr;  ///< none: weight, jet and walls alone
};

}  // namespace talus::layer
