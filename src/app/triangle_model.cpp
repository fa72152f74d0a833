#include "app/triangle_model.hpp"

#include <cmath>

#include "app/theory.hpp"
#include "triangle/fields.hpp"
#include "triangle/triangle.hpp"

namespace talus::app {
namespace {

void check(const Scene& scene, const config::Values& values, config::Problems& problems) {
  const auto refuse = [&](const char* key, const std::string& what) { problems.add(values.place(key), key, what); };
  const std::string instead = ", or model.name = \"layer\"";
  if (scene.box.periodic) refuse("box.periodic", "a triangle has two ends; expected false" + instead);
  if (!scene.box.left_open) refuse("box.left", "the triangle has no wall to lean on; expected open" + instead);
  if (!scene.box.right_open) refuse("box.right", "the triangle drains over its right end; expected open" + instead);
  if (scene.box.lid) refuse("box.surface", "the triangle's surface is free; expected free" + instead);
  if (scene.box.base == experiment::Contact::free_slip || scene.box.base_speed != 0.0)
    refuse("box.base", "grains stick to the triangle's base, which stands still; expected no_slip" + instead);
  if (scene.box.base_friction)
    refuse("box.base_friction", "grains stick to the triangle's base; expected no such key" + instead);
  if (scene.box.base_slip_length > 0.0)
    refuse("box.base_slip_length", "grains stick to the triangle's base; expected 0 m" + instead);
  if (scene.box.base_slope != 0.0) refuse("box.base_slope", "the triangle stands on the grid's x axis; expected 0");
  if (!(scene.inflow.rate > 0.0)) refuse("inflow.rate", "the triangle grows by what is poured; expected above 0 kg/s");
  if (!(scene.wall.mu_w > 0.0)) refuse("wall.mu_w", "without wall friction no heap stands; expected above 0" + instead);
  if (std::holds_alternative<rheology::Constant>(scene.law))
    refuse("rheology.law",
           "constant friction selects no flow down the face; expected classical or partially_regularised");
  if (values.has("schedule.times")) refuse("schedule.times", "the triangle's box stands still; expected no schedule");
  if (scene.initial.state != Initial::State::rest)
    refuse("initial.state", "the triangle starts from an empty box; expected rest");
  if (!(scene.box.tilt >= 0.0 && scene.left_slope + scene.box.tilt < 1.57))
    refuse("box.tilt", "expected at least 0 and, with the left face's slope, below 90 degrees");
  if (!problems.none()) return;
  const double landing = triangle::Frame(make_triangle_parameters(scene)).landing;
  if (!(landing > 0.0 && landing < scene.box.length))
    refuse("inflow.position", "the jet meets the base outside the box, at x = " + std::to_string(landing) + " m");
}

Simulation build(const Scene& scene) {
  auto system = std::make_unique<triangle::Triangle>(make_triangle_parameters(scene));
  auto fields = std::make_unique<triangle::TriangleFields>(*system);
  return {std::move(system), std::move(fields)};
}

}  // namespace

Model triangle_model() {
  return {
      .name = "triangle",
      .doc =
          "a heap as a triangle that drains by the exact steady flow down its face: growth and drain in milliseconds",
      .has_columns = true,
      .has_layers = false,
      .check = check,
      .build = build};
}

triangle::Parameters make_triangle_parameters(const Scene& scene) {
  return {.box = scene.box,
          .inflow = scene.inflow,
          .channel = channel_of(scene),
          .left_slope = scene.left_slope,
          .columns = scene.cells.columns,
          .atol_mass = scene.integration.atol_mass};
}

}  // namespace talus::app
