#include "app/models.hpp"

#include <algorithm>
#include <stdexcept>

#include "layer/fields.hpp"
#include "layer/layer.hpp"

namespace talus::app {
namespace {

Simulation build_layer(const Scene& scene) {
  auto system = std::make_unique<layer::Layer>(make_layer_parameters(scene));
  auto fields = std::make_unique<layer::LayerFields>(*system);
  return {std::move(system), std::move(fields)};
}

}  // namespace

const std::vector<Model>& models() {
  static const std::vector<Model> all{
      {"layer", "a layer of grains under a moving surface H(x, t), in two dimensions, without air", build_layer}};
  return all;
}

const Model& model(std::string_view name) {
  const auto found = std::ranges::find(models(), name, &Model::name);
  if (found == models().end()) throw std::logic_error("no model " + std::string(name));
  return *found;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const auto& each : models()) names.push_back(each.name);
  return names;
}

}  // namespace talus::app
