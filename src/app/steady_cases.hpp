#pragma once

#include <optional>
#include <string>
#include <vector>

#include "steady/ill_posed_depths.hpp"
#include "steady/layer_mean.hpp"
#include "steady/slope.hpp"

namespace talus::app {

/// What a steady flow is to be found from.
enum class SteadyGiven { zeta, flux, mean_speed };

/// A flow and all that is derived from it.
struct SteadyFlow {
  steady::UniformFlow flow;
  double surface_speed;  ///< [m/s]
  double flux;           ///< Q [kg/s]
  double half_depth;     ///< where the speed is half of that at the surface [m]
  double percent_depth;  ///< where it is 1 % [m]
  steady::LayerMean mean;
  steady::IllPosedDepths posed;
  std::vector<double> depths, speeds;  ///< profile [m], [m/s]; from the surface to the end of the flow
};

/// The answer to one angle [degree], flux [kg/s] or depth-averaged speed [m/s].
struct SteadyCase {
  double given;
  std::optional<SteadyFlow> flow;
  std::string reason;  ///< why there is none
};

/// What is asked, and what holds for all answers.
struct SteadyStudy {
  steady::Channel channel;
  double thickness;  ///< [m]; steady::unbounded: a heap
  SteadyGiven given;
  std::size_t points;  ///< of each profile
  steady::PosednessBounds bounds;
  std::optional<double> maximal_flux;            ///< of the law asked for [kg/s]
  std::optional<double> maximal_classical_flux;  ///< of the classical law with the same mu_s, mu_d, I_0 [kg/s]
  std::optional<double> steepest;                ///< no steady flow from this slope on [rad]
  std::vector<SteadyCase> cases;
};

/// Solves for each of `values`, with profiles of `points` points, equally spaced in depth. Throws core::ConfigError that
/// names the option whose value is out of its range.
SteadyStudy solve_steady(const steady::Channel& channel, double thickness, SteadyGiven given,
                         const std::vector<double>& values, int points);

}  // namespace talus::app
