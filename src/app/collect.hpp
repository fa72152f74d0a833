#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::app {

/// Gathers the results of a sweep into sweep.nc and sweep.csv in its folder; of each name in `series` the whole course,
/// too. What members do not have is missing there. Returns the program's exit code. Throws core::Error.
int collect(const std::filesystem::path& folder, const std::vector<std::string>& series, const std::string& command);

}  // namespace talus::app
