#pragma once

#include <filesystem>
#include <string>

#include "app/steady_cases.hpp"

namespace talus::app {

/// Writes the study with its profiles as a netCDF file, dimensions case and point; where there is no steady flow numbers
/// are missing and `reason` says why. `command` is for the file's history. Throws core::OutputError.
void write_steady_file(const std::filesystem::path& path, const SteadyStudy& study, const std::string& command);

}  // namespace talus::app
