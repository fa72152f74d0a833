#include "app/models.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/column_model.hpp"
#include "app/layer_model.hpp"
#include "app/triangle_model.hpp"
#include "app/two_fluid_model.hpp"

namespace talus::app {

const std::vector<Model>& models() {
  static const std::vector<Model> all{triangle_model(), column_model(), layer_model(), two_fluid_model()};
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
