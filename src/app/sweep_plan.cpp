#include "app/sweep_plan.hpp"

#include <algorithm>

#include "app/scene.hpp"
#include "core/errors.hpp"

namespace talus::app {
namespace {

constexpr std::size_t most_told = 10;

std::string key_of(const std::string& assignment) { return assignment.substr(0, assignment.find_first_of(" =")); }

/// The scene as `talus run` of this very text will write it again: read once more, since defaults are then given values.
std::string effective_scene(const std::filesystem::path& scene, const std::vector<std::string>& settings) {
  const std::string once = read_scene(scene, settings).effective;
  return read_scene_text(once, scene.string()).effective;
}

/// What is wrong with members, those with the same words together.
class Refusals {
 public:
  void add(std::size_t member, const std::string& why) {
    ++n_members_;
    const auto known = std::ranges::find(kinds_, why, &Kind::why);
    if (known == kinds_.end()) kinds_.push_back({why, member, 1});
    else ++known->n_members;
  }

  /// Throws core::ConfigError if there are any, naming an example of each kind.
  void throw_if_any(const sweep::SweepFile& file, const std::filesystem::path& name) const {
    if (kinds_.empty()) return;
    std::string message = name.string() + ": " + std::to_string(n_members_) + " of " +
                          std::to_string(file.design.size()) + " members are refused, none was run\n";
    for (std::size_t i = 0; i < std::min(kinds_.size(), most_told); ++i) {
      const auto& [why, member, n] = kinds_[i];
      message += "member " + std::to_string(member) + " (" + file.design.describe(member) + ")" +
                 (n > 1 ? " and " + std::to_string(n - 1) + " more" : "") + ":\n" + why + "\n";
    }
    if (kinds_.size() > most_told) message += "and other members for other reasons\n";
    message.pop_back();
    throw core::ConfigError(message);
  }

 private:
  struct Kind {
    std::string why;
    std::size_t member;  ///< the first
    std::size_t n_members;
  };
  std::vector<Kind> kinds_;
  std::size_t n_members_ = 0;
};

}  // namespace

std::vector<std::string> member_scenes(const sweep::SweepFile& file, const std::filesystem::path& name) {
  std::vector<std::string> scenes;
  Refusals refusals;
  for (std::size_t member = 0; member < file.design.size(); ++member) {
    auto settings = file.settings;
    for (const auto& [axis, value] : file.design.settings(member)) {
      settings.push_back(axis.key + "=" + config::to_toml(config::value_of(value)));
    }
    try {
      scenes.push_back(effective_scene(file.scene, settings));
    } catch (const core::ConfigError& error) { refusals.add(member, error.what()); }
  }
  refusals.throw_if_any(file, name);
  return scenes;
}

std::vector<std::string> settings_beside(const sweep::Dimension& dimension, std::vector<std::string> settings) {
  std::erase_if(settings, [&](const std::string& setting) {
    return std::ranges::find(dimension.axes, key_of(setting), &sweep::Axis::key) != dimension.axes.end();
  });
  return settings;
}

std::vector<std::string> overridden(std::vector<std::string> settings, const std::vector<std::string>& overrides) {
  std::erase_if(settings, [&](const std::string& setting) {
    return std::ranges::any_of(overrides, [&](const std::string& o) { return key_of(o) == key_of(setting); });
  });
  settings.insert(settings.end(), overrides.begin(), overrides.end());
  return settings;
}

SweepPlan plan_sweep(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  SweepPlan plan{sweep::read_sweep(file, scene_schema()), {}};
  plan.file.settings = overridden(plan.file.settings, overrides);
  plan.scenes = member_scenes(plan.file, file);
  return plan;
}

}  // namespace talus::app
