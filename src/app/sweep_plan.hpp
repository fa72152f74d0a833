#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweep/sweep_file.hpp"

namespace talus::app {

/// A sweep with the scenes of all its members, each checked.
struct SweepPlan {
  sweep::SweepFile file;
  std::vector<std::string> scenes;  ///< effective scene of each member, as its run will write it
};

/// The effective scene of each member; `name` stands for the sweep in messages. Throws core::ConfigError naming the members
/// whose scene is refused, with their axis values.
std::vector<std::string> member_scenes(const sweep::SweepFile& file, const std::filesystem::path& name);

/// The user's settings ("key=value") of keys that no axis of the dimension sets: of the others, its points have the say.
std::vector<std::string> settings_beside(const sweep::Dimension& dimension, std::vector<std::string> settings);

/// `settings` but for those of keys that `overrides` set, then the overrides; both "key=value".
std::vector<std::string> overridden(std::vector<std::string> settings, const std::vector<std::string>& overrides);

/// Reads a sweep file and makes the scene of every member. `overrides` hold for all members and win over the file's own
/// settings. Throws core::ConfigError for a bad sweep file, or naming the members whose scene is refused, with their axis
/// values.
SweepPlan plan_sweep(const std::filesystem::path& file, const std::vector<std::string>& overrides);

}  // namespace talus::app
