#include "app/column_model.hpp"

#include <cmath>

#include "app/theory.hpp"
#include "column/column.hpp"
#include "column/fields.hpp"
#include "steady/regularised_profile.hpp"

namespace talus::app {
namespace {

/// The steady profile from which the scene starts; none where there is no such state.
steady::Answer<steady::RegularisedProfile> steady_start(const Scene& scene) {
  auto box = scene.box;
  box.tilt = scene.initial.tilt;
  const double zeta = experiment::base_angle(box);
  if (!(zeta > 0.0))
    return steady::Answer<steady::RegularisedProfile>::none("the base does not slope down to the right");
  if (experiment::base_slides(box))
    return steady::Answer<steady::RegularisedProfile>::none("not known over a base on which grains may slide");
  return steady::RegularisedProfile::at({channel_of(scene), scene.regularisation, scene.wall.u_c,
                                         experiment::normal_thickness(box, scene.initial.thickness)},
                                        zeta);
}

experiment::PiecewiseLinear start_of(const Scene& scene) {
  switch (scene.initial.state) {
    case Initial::State::rest: return {};
    case Initial::State::profile: return scene.initial.profile;
    case Initial::State::steady: break;
  }
  const auto profile = steady_start(scene);
  experiment::PiecewiseLinear start;
  for (const double z : profile->z()) start.at.push_back(-z);
  start.values.assign(profile->speeds().begin(), profile->speeds().end());
  return start;
}

void check(const Scene& scene, const config::Values& values, config::Problems& problems) {
  const auto refuse = [&](const char* key, const std::string& what) { problems.add(values.place(key), key, what); };
  if (!scene.box.periodic)
    refuse("box.periodic", "the column is a uniform layer, without ends; expected true, or model.name = \"layer\"");
  if (scene.inflow.rate > 0.0)
    refuse("inflow.rate", "nothing pours onto a uniform layer; expected 0 kg/s, or model.name = \"layer\"");
  if (!values.has("model.initial_thickness"))
    refuse("model.initial_thickness", "the column's layer neither grows nor drains; expected a number above 0 [m]");
  const char* other = "; expected another setting, or model.name = \"layer\"";
  if (scene.box.lid) refuse("box.surface", std::string("the column's surface is free") + other);
  if (scene.box.base == experiment::Contact::free_slip)
    refuse("box.base", std::string("grains stick to the column's base") + other);
  if (scene.box.base_speed != 0.0) refuse("box.base_speed", std::string("the column's base stands still") + other);
  if (!problems.none() || scene.initial.state != Initial::State::steady) return;
  const auto start = steady_start(scene);
  if (!start) refuse("initial.tilt", "no steady profile to start from: " + start.reason());
}

Simulation build(const Scene& scene) {
  auto system = std::make_unique<column::Column>(make_column_parameters(scene));
  auto fields = std::make_unique<column::ColumnFields>(*system);
  return {std::move(system), std::move(fields)};
}

}  // namespace

Model column_model() {
  return {.name = "column",
          .doc = "a uniform layer on a slope, u(z, t), in one dimension; slope and gap may change in time",
          .has_columns = false,
          .has_layers = true,
          .check = check,
          .build = build};
}

column::Parameters make_column_parameters(const Scene& scene) {
  return {.box = scene.box,
          .motion = scene.motion,
          .grains = scene.grains,
          .law = scene.law,
          .regularisation = scene.regularisation,
          .wall = scene.wall,
          .grid = {scene.cells.layers, scene.cells.spacing,
                   experiment::normal_thickness(scene.box, scene.cells.cluster_depth)},
          .thickness = experiment::normal_thickness(scene.box, scene.initial.thickness),
          .start = start_of(scene),
          .atol_velocity = scene.integration.atol_velocity};
}

}  // namespace talus::app
