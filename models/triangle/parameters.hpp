#pragma once

#include "experiment/experiment.hpp"
#include "steady/channel.hpp"

namespace talus::triangle {

/// All that the triangle needs to know.
struct Parameters {
  experiment::Box box;  ///< not periodic; grains may leave over both ends
  experiment::Inflow inflow;
  steady::Channel channel;  ///< grains, law and walls
  double left_slope;        ///< of the left face against the horizontal, falling to the left [rad]
  int columns;              ///< at whose centres the surface is written
  double atol_mass = 1e-7;  ///< [kg]
};

}  // namespace talus::triangle
