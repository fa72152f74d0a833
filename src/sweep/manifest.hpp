#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweep/design.hpp"
#include "sweep/member_state.hpp"

namespace talus::sweep {

/// What a sweep's folder says of itself.
struct Manifest {
  std::string name;
  std::string title;
  std::string source;  ///< the sweep file, as it was given
  Design design;
  std::vector<MemberState> members;
};

/// Writes manifest.json and, one row a member, manifest.csv, each in one piece. Throws core::OutputError(output_failed).
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

/// Reads manifest.json. Throws core::ConfigError for a folder that holds none or one that Talus did not write.
Manifest read_manifest(const std::filesystem::path& folder);

}  // namespace talus::sweep
