#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/table.hpp"
#include "steady/channel.hpp"

namespace talus::app {

/// What is asked of a law point by point.
struct RheologyPoints {
  std::vector<double> I;            ///< inertial numbers, or
  std::vector<double> mu;           ///< frictions, each turned into its I, or
  std::vector<double> zeta;         ///< slopes [degree], each standing for mu = tan zeta
  std::vector<double> k;            ///< wave numbers [1/m] of the growth rates
  std::optional<double> thickness;  ///< of Bagnold's flow at those slopes [m]
  [[nodiscard]] std::size_t size() const { return I.size() + mu.size() + zeta.size(); }
};

/// One line a point: mu, its slope and inverse, nu, q, C, well-posedness, growth of the fastest wave, Bagnold's flow.
/// A friction that no I has is a line without numbers; `notes` says why.
[[nodiscard]] Table rheology_table(const steady::Channel& channel, const RheologyPoints& points,
                                   std::vector<std::string>& notes);

}  // namespace talus::app
