#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/schema.hpp"
#include "sweep/design.hpp"

namespace talus::sweep {

/// A sweep as its file states it, checked as far as single values go.
struct SweepFile {
  std::string name;                   ///< letters, digits, - and _
  std::string title;                  ///< one line, may be empty
  std::filesystem::path scene;        ///< the file, its path resolved
  std::vector<std::string> settings;  ///< "key=value", for every member
  Design design;
};

/// Every key of a sweep file.
const config::Schema& sweep_schema();

/// Reads a sweep over the keys of `scene_schema`. Throws core::ConfigError that names every problem found, see
/// config::read: also axes over unknown keys or twice over one, and values that their key refuses.
SweepFile read_sweep(const std::filesystem::path& file, const config::Schema& scene_schema);

}  // namespace talus::sweep
