#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/layer_model.hpp"
#include "app/scene.hpp"
#include "core/errors.hpp"

namespace talus::tests {

inline std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(TALUS_SOURCE_DIR) / "runs" / "examples" / (name + ".toml");
}

inline std::vector<std::string> example_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(example("").parent_path()))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

/// An example on a grid of `columns` by `layers`, with further settings "key=value".
inline app::Scene small(const std::string& name, int columns, int layers, std::vector<std::string> settings = {}) {
  settings.push_back("grid.columns=" + std::to_string(columns));
  settings.push_back("grid.layers=" + std::to_string(layers));
  return app::read_scene(example(name), settings);
}

/// An example as a model computes it.
struct Case {
  std::string model, scene;
  [[nodiscard]] app::Scene read(int columns, int layers, std::vector<std::string> settings = {}) const {
    settings.push_back("model.name=" + model);
    return small(scene, columns, layers, std::move(settings));
  }
  /// Whether the model can compute the scene with these settings.
  [[nodiscard]] bool represents(const std::vector<std::string>& settings = {}) const {
    try {
      (void)read(9, 5, settings);
      return true;
    } catch (const core::ConfigError&) { return false; }
  }
};

inline void PrintTo(const Case& each, std::ostream* out) { *out << each.model << " on " << each.scene; }

/// Every example with every registered model that can represent it.
inline std::vector<Case> every_case() {
  std::vector<Case> cases;
  for (const auto& model : app::model_names())
    for (const auto& name : example_names()) {
      const Case each{model, name};
      if (each.represents()) cases.push_back(each);
    }
  return cases;
}

}  // namespace talus::tests
