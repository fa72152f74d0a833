#include "app/presets.hpp"

#include <algorithm>

#include "app/models.hpp"
#include "app/scene.hpp"
#include "app/table.hpp"
#include "config/key.hpp"

namespace talus::app {
namespace {

constexpr int fewest_columns = 8, fewest_preset_layers = 4;

int divided(int cells, int divisor, int fewest) { return std::min(cells, std::max(fewest, cells / divisor)); }

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all{
      {"draft", "a fifth of the columns, a quarter of the layers, three times rtol", 5, 4, 3.0,
       "60x8: slope off the exact one by 0.45 degrees, stored mass off that of fine by 1 to 5 %; 2.2 s of CPU, 1.8 s on two cores"},
      {"standard", "half the columns, half the layers", 2, 2, 1.0,
       "150x16: slope off by 0.28 degrees, mass by 0.3 %; 16 s of CPU, 10 s on two cores"},
      {"fine", "the scene as its file states it", 1, 1, 1.0,
       "300x32: slope off by 0.21 degrees; 79 s of CPU, 45 s on two cores"}};
  return all;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const auto& preset : presets()) names.push_back(preset.name);
  return names;
}

std::vector<std::string> with_preset(const std::filesystem::path& scene_file, const std::string& name,
                                     std::vector<std::string> overrides) {
  const auto& preset = *std::ranges::find(presets(), name, &Preset::name);
  const Scene scene = read_scene(scene_file, overrides);
  const auto& its = model(scene.model);
  std::vector<std::string> out;
  const auto add = [&](const std::string& key, const std::string& value) {
    const auto sets = [&](const std::string& o) { return o.substr(0, o.find_first_of(" =")) == key; };
    if (std::ranges::none_of(overrides, sets)) out.push_back(key + "=" + value);
  };
  if (its.has_layers) {
    if (its.has_columns)
      add("grid.columns", std::to_string(divided(scene.cells.columns, preset.columns_divisor, fewest_columns)));
    add("grid.layers", std::to_string(divided(scene.cells.layers, preset.layers_divisor, fewest_preset_layers)));
  }
  add("integrator.rtol", config::to_toml(scene.integration.rtol * preset.rtol_factor));
  out.insert(out.end(), overrides.begin(), overrides.end());
  return out;
}

std::string explain_presets() {
  std::string out = "Presets of `talus run SCENE.toml --preset NAME`; what --set states wins over them.\n\n";
  for (const auto& preset : presets()) out += preset.name + ": " + preset.doc + ".\n  " + preset.measured + "\n";
  return out +
         "\nMeasured on runs/examples/heap_q46.toml, 320 s of growth and drain, on 2026-11-26, on quiet cores; `talus "
         "study trade` "
         "measures other "
         "scenes.\n";
}

}  // namespace talus::app
