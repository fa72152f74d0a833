#include "app/two_fluid_model.hpp"

#include "app/theory.hpp"
#include "experiment/inflow.hpp"
#include "steady/slope.hpp"
#include "two_fluid/fields.hpp"
#include "two_fluid/two_fluid.hpp"

namespace talus::app {
namespace {

/// Of the highest surface that the scene's flow can have [rad].
std::optional<double> reach_slope(const Scene& scene) {
  if (scene.two_fluid.reach.slope || !(scene.wall.mu_w > 0.0)) return scene.two_fluid.reach.slope;
  const auto exact = steady::slope_of_flux(channel_of(scene), experiment::largest_rate(scene.inflow));
  return exact ? std::optional(*exact) : std::nullopt;
}

void check(const Scene& scene, const config::Values& values, config::Problems& problems) {
  const auto refuse = [&](const char* key, const std::string& what) { problems.add(values.place(key), key, what); };
  const std::string instead = ", or model.name = \"layer\"";
  const auto& box = scene.box;
  if (box.lid) refuse("box.surface", "the air above the grains is open; expected free" + instead);
  if (box.base == experiment::Contact::free_slip || box.base_speed != 0.0)
    refuse("box.base",
           "grains and air stick to a base that stands still; expected no_slip and base_speed = 0" + instead);
  if (box.base_friction)
    refuse("box.base_friction", "grains and air stick to the base; expected no such key" + instead);
  if (box.base_slip_length > 0.0)
    refuse("box.base_slip_length", "grains and air stick to the base; expected 0 m" + instead);
  if (box.base_slope != 0.0) refuse("box.base_slope", "the base is a grid line; expected 0, and the slope in box.tilt");
  if (box.end_walls == experiment::Contact::no_slip)
    refuse("box.end_walls", "grains and air slip along end walls; expected free_slip" + instead);
  if (values.has("schedule.times"))
    refuse("schedule.times",
           "the two-fluid model's box stands still; expected no schedule, or model.name = \"column\"");
  if (scene.initial.state != Initial::State::rest)
    refuse("initial.state", "the two-fluid model starts at rest; expected rest, or model.name = \"column\"");
  if (scene.inflow.rate > 0.0) {
    const double half = 0.5 * two_fluid::inlet_width(scene.inflow);
    if (scene.inflow.position - half < 0.0 || scene.inflow.position + half > box.length)
      refuse("inflow.position", "the inlet, sqrt(12) inflow.width wide, leaves the top of the box");
    if (!box.left_open && !box.right_open)
      refuse("box.right", "grains that are poured must find a way out; expected an open end");
  }
  if (scene.two_fluid.jet == two_fluid::Jet::free_fall && scene.two_fluid.jet_segregation)
    refuse("two_fluid.jet_segregation",
           "no jet region is left where grains fall freely; expected false, or two_fluid.jet = \"resolved\"");
  if (scene.two_fluid.reach.limited) {
    if (!(scene.inflow.rate > 0.0))
      refuse("two_fluid.cells",
             "reachable cells are those that a jet pours grains into; expected box where nothing is poured");
    else if (scene.inflow.shares.size() == scene.inflow.times.size() && !reach_slope(scene))  // else refused already
      refuse("two_fluid.cells", "no steady slope is known for this flow; expected two_fluid.reach_slope, or box");
  }
  if (scene.integration.method == Integration::Method::steady)
    refuse("integrator.method", "the two-fluid model has no steady states of its own; expected bdf");
}

Simulation build(const Scene& scene) {
  auto system = std::make_unique<two_fluid::TwoFluid>(make_two_fluid_parameters(scene));
  auto fields = std::make_unique<two_fluid::TwoFluidFields>(*system);
  return {std::move(system), std::move(fields)};
}

two_fluid::Advection advection_of(layer::Advection advection) {
  switch (advection) {
    case layer::Advection::none: return two_fluid::Advection::none;
    case layer::Advection::upwind: return two_fluid::Advection::upwind;
    case layer::Advection::central: break;
  }
  return two_fluid::Advection::central;
}

}  // namespace

Model two_fluid_model() {
  return {.name = "two_fluid",
          .doc = "grains and air on a fixed grid, in two dimensions: jets, splashes, surfaces that overturn",
          .has_columns = true,
          .has_layers = true,
          .fixed_grid = true,
          .check = check,
          .build = build};
}

two_fluid::Parameters make_two_fluid_parameters(const Scene& scene) {
  two_fluid::Parameters par{
      .box = scene.box,
      .grains = scene.grains,
      .law = scene.law,
      .regularisation = scene.regularisation,
      .wall = scene.wall,
      .inflow = scene.inflow,
      .grid = {scene.cells.columns, scene.cells.layers, scene.two_fluid.x_grading, scene.two_fluid.z_grading},
      .numerics = scene.two_fluid,
      .thickness = scene.initial.thickness,
      .atol_velocity = scene.integration.atol_velocity,
      .atol_pressure = scene.integration.atol_pressure,
      .atol_height = scene.integration.atol_height,
      .atol_mass = scene.integration.atol_mass};
  if (par.numerics.reach.limited) par.numerics.reach.slope = reach_slope(scene);
  par.numerics.advection = advection_of(scene.numerics.advection);
  return par;
}

}  // namespace talus::app
