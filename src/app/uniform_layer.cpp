#include "app/uniform_layer.hpp"

#include <algorithm>

#include "core/errors.hpp"
#include "kinsol/kinsol.hpp"

namespace talus::app {

std::string why_not_uniform(const Scene& scene) {
  if (scene.box.periodic && !scene.box.lid && !(scene.inflow.rate > 0.0) &&
      scene.box.base == experiment::Contact::no_slip && scene.box.base_speed == 0.0 && scene.box.base_slope == 0.0)
    return "";
  return "expected box.periodic = true, a free surface, no inflow, and a base to which grains stick, at rest and along "
         "x";
}

Scene uniform_layer_at_rest(const Scene& scene) {
  if (scene.model != "layer" && scene.model != "column")
    throw core::ConfigError("study wellposed: expected model.name = \"layer\" or \"column\", found \"" + scene.model +
                            "\"");
  if (const auto why = why_not_uniform(scene); !why.empty())
    throw core::ConfigError("study wellposed: waves need a uniform layer: " + why);
  Scene still = scene;
  still.box = experiment::box_at(scene.box, scene.motion, scene.end);
  still.motion = {};
  still.initial.state = Initial::State::rest;
  still.initial.disturbance = std::nullopt;
  return still;
}

std::vector<double> steady_speeds(const column::Column& column, const Scene& scene) {
  core::Observer nobody;
  kinsol::Options options;
  options.rtol = std::min(scene.integration.rtol, 1e-8);
  kinsol::Kinsol steady(column, options);
  const auto n = static_cast<std::size_t>(column.layout().size());
  steady.start(0.0, std::vector<double>(n, 0.0), std::vector<double>(n, 0.0));
  steady.advance(scene.end, nobody);
  const auto now = steady.current();
  return {now.y.begin(), now.y.end()};
}

}  // namespace talus::app
