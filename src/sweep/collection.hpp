#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/table_file.hpp"
#include "sweep/manifest.hpp"

namespace talus::sweep {

/// The results of a sweep in one place.
struct Collection {
  std::vector<MemberState> members;
  output::Table table;  ///< along the sweep's dimensions
  std::string csv;      ///< one row a member: axes, status, last numbers and counters
};

/// Reads the summaries of all members and, of each name in `series`, the single number that run.nc holds along
/// series_time. What a member does not have is NaN; its last numbers count only if it is finished. Units and long names
/// are those of run.nc. Throws core::ConfigError for a series that no member has; core::OutputError for a run.nc that
/// cannot be read.
Collection collect(const std::filesystem::path& folder, const Manifest& manifest,
                   const std::vector<std::string>& series);

}  // namespace talus::sweep
