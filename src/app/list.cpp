#include "app/list.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "app/build_info.hpp"
#include "app/models.hpp"
#include "app/scene.hpp"

namespace talus::app {

std::string list() {
  std::string out = "models\n";
  for (const auto& each : models()) out += "  " + each.name + ": " + each.doc + "\n";
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(build::examples)) {
    for (const auto& entry : std::filesystem::directory_iterator(build::examples)) {
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  out += "scenes in " + std::string(build::examples) + "\n";
  for (const auto& file : files) out += "  " + file.filename().string() + ": " + read_scene(file).title + "\n";
  return out;
}

}  // namespace talus::app
