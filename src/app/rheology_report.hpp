#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/table.hpp"
#include "rheology/law.hpp"

namespace talus::app {

/// What is asked of a law point by point.
struct RheologyPoints {
  std::vector<double> I;   ///< inertial numbers, or
  std::vector<double> mu;  ///< frictions, each turned into its I
  std::vector<double> k;   ///< wave numbers [1/m] of the growth rates
};

/// One line a point: mu, its slope and inverse, nu, q, C, well-posedness, growth of the fastest wave. A friction that
/// no I has is a line without numbers; `notes` says why.
[[nodiscard]] Table rheology_table(const rheology::Law& law, const rheology::Grains& grains,
                                   const RheologyPoints& points, std::vector<std::string>& notes);

/// rheology.law of a scene that asks for this law.
[[nodiscard]] std::string law_word(const rheology::Law& law);

/// The law as a whole: its parameters, limits, neutral points, bounds and ranges of well-posedness. Numbers that do not
/// exist are null; a range that never ends has the end null.
[[nodiscard]] nlohmann::ordered_json rheology_summary(const rheology::Law& law);

/// The same for people.
[[nodiscard]] std::string rheology_text(const rheology::Law& law);

}  // namespace talus::app
