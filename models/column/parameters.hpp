#pragma once

#include "experiment/experiment.hpp"
#include "grid/layering.hpp"
#include "rheology/law.hpp"
#include "rheology/viscosity.hpp"

namespace talus::column {

struct Grid {
  int layers;
  grid::Spacing spacing;
  double cluster_depth;  ///< see grid::Layering [m]
};

/// All that the column model needs to know.
struct Parameters {
  experiment::Box box;  ///< its lengths along x and over the base do not matter
  experiment::Motion motion;
  rheology::Grains grains;
  rheology::Law law;
  rheology::Regularisation regularisation;
  experiment::Wall wall;
  Grid grid;
  double thickness;  ///< normal to the base, H [m]
  experiment::PiecewiseLinear
      start;                    ///< speeds down the slope [m/s] over the depth below the surface [m]; empty: at rest
  double atol_velocity = 1e-5;  ///< [m/s]
};

}  // namespace talus::column
