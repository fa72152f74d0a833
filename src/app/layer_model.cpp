#include "app/layer_model.hpp"

#include "app/words.hpp"
#include "layer/fields.hpp"
#include "layer/layer.hpp"

namespace talus::app {
namespace {

void check(const Scene& scene, const config::Values& values, config::Problems& problems) {
  const auto refuse = [&](const char* key, const std::string& what) { problems.add(values.place(key), key, what); };
  if (!(scene.numerics.jump_to > scene.numerics.jump_from)) refuse("model.jump_to", "expected above model.jump_from");
  const double film = scene.numerics.film;
  if (scene.initial.thickness < film)
    refuse("model.initial_thickness", "expected at least model.film = " + words::in_metres(film));
  if (film >= scene.box.height)
    refuse("model.film", "expected below box.height = " + words::in_metres(scene.box.height));
  const auto& box = scene.box;
  if (box.lid && !box.periodic && (box.left_open || box.right_open))
    refuse("box.surface",
           "a lid closes the box; expected box.periodic = true, or \"wall\" for both box.left and box.right");
  if (box.lid && scene.inflow.rate > 0.0)
    refuse("inflow.rate", "nothing pours through the lid; expected 0 kg/s, or box.surface = \"free\"");
  if (values.has("schedule.times"))
    refuse("schedule.times", "the layer model's box stands still; expected no schedule, or model.name = \"column\"");
  if (scene.initial.state != Initial::State::rest)
    refuse("initial.state", "the layer model starts at rest; expected rest, or model.name = \"column\"");
}

Simulation build(const Scene& scene) {
  auto system = std::make_unique<layer::Layer>(make_layer_parameters(scene));
  auto fields = std::make_unique<layer::LayerFields>(*system);
  return {std::move(system), std::move(fields)};
}

}  // namespace

Model layer_model() {
  return {.name = "layer",
          .doc = "a layer of grains under a moving surface H(x, t), in two dimensions, without air",
          .has_columns = true,
          .has_layers = true,
          .check = check,
          .build = build};
}

layer::Parameters make_layer_parameters(const Scene& scene) {
  return {.box = scene.box,
          .grains = scene.grains,
          .law = scene.law,
          .regularisation = scene.regularisation,
          .wall = scene.wall,
          .inflow = scene.inflow,
          .grid = {scene.cells.columns, scene.cells.layers, scene.cells.cluster_depth, scene.cells.spacing},
          .numerics = scene.numerics,
          .initial = {scene.initial.thickness},
          .atol_velocity = scene.integration.atol_velocity,
          .atol_pressure = scene.integration.atol_pressure,
          .atol_height = scene.integration.atol_height,
          .atol_mass = scene.integration.atol_mass};
}

}  // namespace talus::app
