#pragma once

#include <cstdint>
#include <optional>

#include "experiment/experiment.hpp"
#include "rheology/law.hpp"
#include "rheology/viscosity.hpp"

namespace talus::two_fluid {

using experiment::Box;
using experiment::Inflow;
using experiment::Wall;

/// The excess air: what fills the box where there are no grains.
struct Air {
  double rho = 1.0;             ///< [kg/m3]
  double eta = 1e-2;            ///< viscosity, thickened to calm the air [Pa s]
  double drag_viscosity = 0.0;  ///< in the drag 12 eta/W^2 of the side walls on the air [Pa s]; 0: none
};

/// What keeps grains and air apart.
enum class Sharpening : std::uint8_t { none, segregation, counter_gradient };
/// Along which the grains are parted from the air: gravity, as in (5.2), the normal of the base, or as single grains settle: along gravity,
/// but along the base only by the share of air in the cell beneath, since grains that rest on others do not slip through them.
enum class Direction : std::uint8_t { gravity, base_normal, settling };
/// How phi on a face follows from the cells: first order, or second order where phi is smooth, everywhere or in the jet region alone.
enum class Transport : std::uint8_t { upwind, limited, jet };
/// How the viscosities of grains and air make that of a mixture: (5.7), or their harmonic mean.
enum class Averaging : std::uint8_t { arithmetic, harmonic };
/// The jet from the inlet to the heap: solved for like all else, or known: grains in free fall, which enter the cells above the heap.
enum class Jet : std::uint8_t { resolved, free_fall };
/// Inertia carried along: none, first-order upwind, second-order central.
enum class Advection : std::uint8_t { none, upwind, central };

/// Which cells of the box have unknowns.
struct Reach {
  bool limited = false;  ///< only those that grains can reach: the heap's hull, the jet's corridor, a margin; else all
  std::optional<double>
      slope;  ///< of the hull against the horizontal, the steepest that a surface gets [rad]; set where limited
  double margin = 0.06;  ///< above the hull and beside the corridor [m]
};

/// Cells of the box: each direction in geometric progression.
struct Grid {
  int columns, layers;
  double x_ratio = 1.0;  ///< width of the last column over that of the first
  double z_ratio = 1.0;  ///< height of the top layer over that of the lowest
};

/// Numerical devices, each named.
struct Numerics {
  Sharpening sharpening = Sharpening::segregation;
  double segregation_speed = 0.1;  ///< f_ga of (5.2) [m/s]
  double counter_gradient = 1.0;   ///< c_ag of (5.8) [1]
  Direction direction = Direction::gravity;
  Jet jet = Jet::resolved;
  bool jet_segregation = false;  ///< grains settle in the jet, too: Omega of (5.13) is 1 everywhere
  Transport transport = Transport::jet;
  Averaging averaging = Averaging::arithmetic;
  Advection advection = Advection::upwind;
  bool base_film = false;      ///< a film thinner than its cell meets the base with its own thickness
  double upwind_speed = 1e-8;  ///< over which the giving side changes [m/s]
  double return_speed = 0.1;   ///< at which what is out of [0, 1] goes to the neighbours; 0: it stays [m/s]
  double x_grading = 1.0;      ///< as Grid::x_ratio
  double z_grading = 1.0;      ///< as Grid::z_ratio
  Reach reach;
  double atol_fraction = 1e-5;  ///< absolute tolerance of phi [1]
  double inlet_fraction = 0.2;  ///< phi of what is poured [1]
  double jet_margin = 0.025;    ///< of the jet region beyond the inlet's edges (5.11) [m]
  double jet_clearance = 0.02;  ///< of the jet region above the heap (5.12); free fall ends within it [m]
  Air air;
};

/// All that the two-fluid model needs to know.
struct Parameters {
  Box box;
  rheology::Grains grains;
  rheology::Law law;
  rheology::Regularisation regularisation;
  Wall wall;
  Inflow inflow;
  Grid grid;
  Numerics numerics;
  double thickness = 0.0;       ///< of the grains at rest on the base at the start [m]
  double atol_velocity = 1e-4;  ///< [m/s]
  double atol_pressure = 0.1;   ///< [Pa]
  double atol_height = 1e-4;    ///< of the heap's highest point [m]
  double atol_mass = 1e-5;      ///< of the budgets [kg]
};

}  // namespace talus::two_fluid
