#pragma once

#include <string>
#include <vector>

#include "output/attributes.hpp"

namespace talus::output {

/// Version of Talus, for example "0.1.0".
[[nodiscard]] std::string version();
/// Git revision of the source this was built from, with "-dirty" where it had uncommitted changes; "unknown" outside
/// git.
[[nodiscard]] std::string git_revision();
/// For example "netCDF 4.9.0".
[[nodiscard]] std::string netcdf_version();

/// Where a result comes from.
struct Provenance {
  std::string scene_text;              ///< the effective scene, all overrides and defaults in it; empty: no scene
  std::string command;                 ///< as typed
  std::vector<std::string> libraries;  ///< names with versions; netCDF's is added here
};

/// Global attributes `source`, `talus_version`, `git_revision`, `libraries`, `scene`, `history` (with the time now,
/// UTC).
[[nodiscard]] Attributes provenance_attributes(const Provenance& provenance);

}  // namespace talus::output
