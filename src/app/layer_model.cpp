#include "app/layer_model.hpp"

#include "app/column_model.hpp"
#include "app/uniform_layer.hpp"
#include "app/words.hpp"
#include "layer/fields.hpp"
#include "layer/layer.hpp"

namespace talus::app {
namespace {

void check_start(const Scene& scene, const config::Values& values, config::Problems& problems) {
  const auto refuse = [&](const char* key, const std::string& what) { problems.add(values.place(key), key, what); };
  if (scene.initial.state == Initial::State::profile)
    refuse("initial.state",
           "the layer model starts at rest or in its steady state; expected rest or steady, or model.name = "
           "\"column\"");
  const auto why = why_not_uniform(scene);
  if (scene.initial.state == Initial::State::steady && !why.empty())
    refuse("initial.state", "a layer's steady state is that of a uniform layer: " + why);
  if (values.has("initial.tilt"))
    refuse("initial.tilt", "the layer model starts in the steady state of its own box; expected no such key");
  const auto& disturbance = scene.initial.disturbance;
  if (!disturbance) return;
  if (!scene.box.periodic) refuse("disturbance.speed", "whole waves need box.periodic = true; expected 0 m/s");
  if (disturbance->last_wave < disturbance->first_wave)
    refuse("disturbance.last_wave", "expected at least disturbance.first_wave");
  const int most = (scene.cells.columns - 1) / 2;
  if (disturbance->last_wave > most)
    refuse(values.has("disturbance.last_wave") ? "disturbance.last_wave" : "disturbance.first_wave",
           "the columns carry waves of more than two of them; expected at most " + std::to_string(most));
  if (disturbance->profiles > scene.cells.layers)
    refuse("disturbance.profiles", "expected at most grid.layers = " + std::to_string(scene.cells.layers));
}

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
  check_start(scene, values, problems);
}

Simulation build(const Scene& scene) {
  auto parameters = make_layer_parameters(scene);
  if (scene.initial.state == Initial::State::steady)
    parameters.initial.speeds =
        steady_speeds(column::Column(make_column_parameters(uniform_layer_at_rest(scene))), scene);
  auto system = std::make_unique<layer::Layer>(std::move(parameters));
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
          .initial = {scene.initial.thickness, {}, scene.initial.disturbance},
          .atol_velocity = scene.integration.atol_velocity,
          .atol_pressure = scene.integration.atol_pressure,
          .atol_height = scene.integration.atol_height,
          .atol_mass = scene.integration.atol_mass};
}

}  // namespace talus::app
