#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene.hpp"

namespace talus::tests {

inline std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(TALUS_SOURCE_DIR) / "runs" / "examples" / (name + ".toml");
}

/// Every example scene of the layer model.
inline std::vector<std::string> layer_examples() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(TALUS_SOURCE_DIR) / "runs" / "examples"))
    if (entry.path().extension() == ".toml" && app::read_scene(entry.path()).model == "layer")
      names.push_back(entry.path().stem());
  return names;
}

/// An example on a grid of `columns` by `layers`, with further settings "key=value".
inline app::Scene small(const std::string& name, int columns, int layers, std::vector<std::string> settings = {}) {
  settings.push_back("grid.columns=" + std::to_string(columns));
  settings.push_back("grid.layers=" + std::to_string(layers));
  return app::read_scene(example(name), settings);
}

}  // namespace talus::tests
