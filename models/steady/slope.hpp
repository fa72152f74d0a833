#pragma once

#include <optional>
#include <string>

#include "steady/uniform_flow.hpp"

namespace talus::steady {

/// The flow that carries Q [kg/s] > 0. None where no slope does: reasons as `UniformFlow::at`, or Q above the largest
/// flux.
[[nodiscard]] Answer<UniformFlow> flow_of_flux(const Channel& channel, double Q, double thickness = unbounded);
/// zeta [rad] of that flow.
[[nodiscard]] Answer<double> slope_of_flux(const Channel& channel, double Q, double thickness = unbounded);

/// The flow whose depth-averaged speed, see `layer_mean`, is `speed` [m/s] > 0. The average drops where a base begins to
/// bound the flow; of two slopes with one speed this is the smaller one.
[[nodiscard]] Answer<UniformFlow> flow_of_mean_speed(const Channel& channel, double speed,
                                                     double thickness = unbounded);

/// sup of Q [kg/s] over all slopes of a heap, or of a layer over a base, where the law saturates: reached as tan zeta ->
/// mu_d. Closed form for the classical law. None where the flux has no bound: mu_inf > 0, or no wall friction. None for
/// constant friction, too, which selects no speed.
[[nodiscard]] std::optional<double> maximal_flux(const Channel& channel, double thickness = unbounded);

/// The slope of tangent `mu` for a message, "41.9872 degrees".
[[nodiscard]] std::string in_degrees(double mu);

}  // namespace talus::steady
