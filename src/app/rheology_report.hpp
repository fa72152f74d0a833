#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "rheology/law.hpp"

namespace talus::app {

/// rheology.law of a scene that asks for this law.
[[nodiscard]] std::string law_word(const rheology::Law& law);

/// The law as a whole: its parameters, limits, neutral points, bounds and ranges of well-posedness. Numbers that do not
/// exist are null; a range that never ends has the end null.
[[nodiscard]] nlohmann::ordered_json rheology_summary(const rheology::Law& law);

/// The same for people.
[[nodiscard]] std::string rheology_text(const rheology::Law& law);

}  // namespace talus::app
