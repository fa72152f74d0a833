#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/growth_study.hpp"
#include "output/table_file.hpp"

namespace talus::app {

/// "64x96": where the grids cannot tell, the one that may; else "".
std::string grid_that_may_tell(const GrowthStudy& study);

/// The verdict, then a line a disturbance.
std::string sentence_of(const GrowthStudy& study);
nlohmann::ordered_json json_of(const GrowthStudy& study);
/// Adds variables growth_... along `growth_disturbance`, `growth_grid` and `growth_point`.
void add_to(output::Table& table, const GrowthStudy& study);

}  // namespace talus::app
