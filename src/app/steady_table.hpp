#pragma once

#include <string>

#include "app/steady_cases.hpp"

namespace talus::app {

/// The study as aligned columns with units for people, a sentence for each value without a steady state, and, if
/// `profiles`, a table of each flow through its depth.
std::string steady_table(const SteadyStudy& study, bool profiles);

}  // namespace talus::app
