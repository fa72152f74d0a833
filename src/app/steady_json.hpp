#pragma once

#include <string>

#include "app/steady_cases.hpp"

namespace talus::app {

/// The study as JSON: SI units in the names, doubles in the shortest form that reads back to the same bits, null where a
/// quantity has no finite value. Profiles are part of it if `profiles`.
std::string steady_json(const SteadyStudy& study, bool profiles);

}  // namespace talus::app
