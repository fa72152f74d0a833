#include "app/scene.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "app/material.hpp"
#include "app/models.hpp"
#include "app/scene_checks.hpp"
#include "app/words.hpp"
#include "config/problems.hpp"
#include "config/read.hpp"

namespace talus::app {
namespace {

using config::Problems;
using config::Values;

double number_or(const Values& v, std::string_view key, double absent) { return v.has(key) ? v.number(key) : absent; }

int small_integer(const Values& v, std::string_view key) { return static_cast<int>(v.integer(key)); }

/// Multiples of `interval` up to `end`, ascending; one within rounding of a time in `known` (ascending, `end` is in it) is that
/// time.
std::vector<double> multiples(double interval, double end, const std::vector<double>& known) {
  std::vector<double> times;
  const double close = 1e-9 * std::max(end, interval);
  for (std::int64_t k = 1; static_cast<double>(k) * interval <= end + close; ++k) {
    const double t = static_cast<double>(k) * interval;
    const auto next = std::ranges::lower_bound(known, t - close);
    times.push_back(next == known.end() || *next > t + close ? t : *next);
  }
  return times;
}

/// `times`, multiples of `interval` (0: none), 0 and `end`, ascending.
std::vector<double> record_times(std::vector<double> times, double interval, double end) {
  times.insert(times.end(), {0.0, end});
  std::ranges::sort(times);
  if (interval > 0.0) {
    const auto more = multiples(interval, end, times);
    times.insert(times.end(), more.begin(), more.end());
    std::ranges::sort(times);
  }
  times.erase(std::ranges::unique(times).begin(), times.end());
  return times;
}

experiment::Inflow inflow_of(const Values& v) {
  experiment::Inflow inflow;
  inflow.rate = v.number("inflow.rate");
  inflow.position = number_or(v, "inflow.position", inflow.position);
  inflow.width = number_or(v, "inflow.width", inflow.width);
  inflow.start = v.number("inflow.start");
  inflow.stop = number_or(v, "inflow.stop", inflow.stop);
  inflow.ramp = v.number("inflow.ramp");
  if (v.has("inflow.times")) inflow.times = v.numbers("inflow.times");
  if (v.has("inflow.shares")) inflow.shares = v.numbers("inflow.shares");
  inflow.along_gravity = v.boolean("inflow.along_gravity");
  inflow.momentum = v.boolean("inflow.momentum");
  return inflow;
}

constexpr double degree = std::numbers::pi / 180.0;

std::optional<experiment::Lid> lid_of(const Values& v) {
  if (!words::meaning(words::surfaces, v.text("box.surface"))) return std::nullopt;
  return experiment::Lid{.contact = words::meaning(words::contacts, v.text("box.lid")),
                         .speed = v.number("box.lid_speed"),
                         .pressure = v.number("box.lid_pressure")};
}

experiment::Box box_of(const Values& v) {
  return {.length = v.number("box.length"),
          .height = v.number("box.height"),
          .tilt = v.number("box.tilt") * degree,
          .gap = v.number("box.gap"),
          .gravity = v.number("box.gravity"),
          .periodic = v.boolean("box.periodic"),
          .left_open = words::meaning(words::ends, v.text("box.left")),
          .base_slope = v.number("box.base_slope"),
          .right_open = words::meaning(words::ends, v.text("box.right")),
          .end_walls = words::meaning(words::contacts, v.text("box.end_walls")),
          .base = words::meaning(words::contacts, v.text("box.base")),
          .base_speed = v.number("box.base_speed"),
          .base_friction = v.has("box.base_friction") ? std::optional(v.number("box.base_friction")) : std::nullopt,
          .base_slip_length = v.number("box.base_slip_length"),
          .lid = lid_of(v)};
}

/// `values` over `points`; empty where either is not given.
experiment::PiecewiseLinear given_at(const Values& v, std::string_view points, std::string_view values, double unit) {
  if (!v.has(points) || !v.has(values)) return {};
  experiment::PiecewiseLinear f{v.numbers(points), v.numbers(values)};
  for (double& value : f.values) value *= unit;
  return f;
}

experiment::Motion motion_of(const Values& v) {
  return {.tilt = given_at(v, "schedule.times", "schedule.tilt", degree),
          .gap = given_at(v, "schedule.times", "schedule.gap", 1.0)};
}

std::optional<layer::Disturbance> disturbance_of(const Values& v) {
  const double speed = v.number("disturbance.speed");
  if (!(speed > 0.0)) return std::nullopt;
  const int first = small_integer(v, "disturbance.first_wave");
  return layer::Disturbance{
      .speed = speed,
      .first_wave = first,
      .last_wave = v.has("disturbance.last_wave") ? small_integer(v, "disturbance.last_wave") : first,
      .profiles = small_integer(v, "disturbance.profiles"),
      .seed = static_cast<std::uint64_t>(small_integer(v, "disturbance.seed"))};
}

Initial initial_of(const Values& v, const Scene& scene) {
  const double unstated = model(scene.model).fixed_grid ? 0.0 : scene.numerics.film;
  return {.thickness = number_or(v, "model.initial_thickness", unstated),
          .state = words::meaning(words::initial_states, v.text("initial.state")),
          .profile = given_at(v, "initial.depths", "initial.speeds", 1.0),
          .tilt = v.has("initial.tilt") ? v.number("initial.tilt") * degree : scene.box.tilt,
          .disturbance = disturbance_of(v)};
}

Cells cells_of(const Values& v) {
  return {.columns = v.has("grid.columns") ? small_integer(v, "grid.columns") : 0,
          .layers = small_integer(v, "grid.layers"),
          .spacing = words::meaning(words::spacings, v.text("grid.spacing")),
          .cluster_depth = v.number("grid.cluster_depth")};
}

rheology::Regularisation regularisation_of(const Values& v) {
  return {.p_0 = v.number("rheology.p_0"),
          .rate_floor = v.number("rheology.rate_floor"),
          .rate_speed = v.number("rheology.rate_speed"),
          .eta_max = v.number("rheology.eta_max"),
          .cap = words::meaning(words::caps, v.text("rheology.cap"))};
}

layer::Numerics numerics_of(const Values& v) {
  return {.advection = words::meaning(words::advections, v.text("model.advection")),
          .film = v.number("model.film"),
          .film_blend = v.number("model.film_blend"),
          .jump_from = v.number("model.jump_from"),
          .jump_to = v.number("model.jump_to"),
          .film_speed = v.number("model.film_speed")};
}

two_fluid::Numerics two_fluid_of(const Values& v) {
  two_fluid::Numerics n;
  n.sharpening = words::meaning(words::sharpenings, v.text("two_fluid.sharpening"));
  n.segregation_speed = v.number("two_fluid.segregation_speed");
  n.counter_gradient = v.number("two_fluid.counter_gradient");
  n.direction = words::meaning(words::directions, v.text("two_fluid.direction"));
  n.jet = words::meaning(words::jets, v.text("two_fluid.jet"));
  n.jet_segregation = v.boolean("two_fluid.jet_segregation");
  n.transport = words::meaning(words::transports, v.text("two_fluid.transport"));
  n.averaging = words::meaning(words::averagings, v.text("two_fluid.averaging"));
  n.base_film = v.boolean("two_fluid.base_film");
  n.upwind_speed = v.number("two_fluid.upwind_speed");
  n.return_speed = v.number("two_fluid.return_speed");
  n.x_grading = v.number("two_fluid.x_grading");
  n.z_grading = v.number("two_fluid.z_grading");
  n.reach.limited = words::meaning(words::extents, v.text("two_fluid.cells"));
  if (v.has("two_fluid.reach_slope")) n.reach.slope = v.number("two_fluid.reach_slope") * degree;
  n.reach.margin = v.number("two_fluid.reach_margin");
  n.atol_fraction = number_or(v, "two_fluid.atol_fraction", 0.1 * v.number("integrator.rtol"));
  n.inlet_fraction = v.number("two_fluid.inlet_fraction");
  n.jet_margin = v.number("two_fluid.jet_margin");
  n.jet_clearance = v.number("two_fluid.jet_clearance");
  n.air = {.rho = v.number("two_fluid.air_density"),
           .eta = v.number("two_fluid.air_viscosity"),
           .drag_viscosity = v.number("two_fluid.air_drag_viscosity")};
  return n;
}

Integration integration_of(const Values& v) {
  const double rtol = v.number("integrator.rtol");
  return {.method = words::meaning(words::methods, v.text("integrator.method")),
          .rtol = rtol,
          .atol_velocity = number_or(v, "integrator.atol_velocity", 0.1 * rtol),
          .atol_pressure = number_or(v, "integrator.atol_pressure", 1e3 * rtol),
          .atol_height = number_or(v, "integrator.atol_height", 0.01 * rtol),
          .atol_mass = number_or(v, "integrator.atol_mass", 0.1 * rtol),
          .max_order = small_integer(v, "integrator.max_order"),
          .linear_solver = words::meaning(words::linear_solvers, v.text("integrator.linear_solver")),
          .newton = words::meaning(words::newtons, v.text("integrator.newton")),
          .newton_tolerance = v.number("integrator.newton_tolerance"),
          .max_step = number_or(v, "integrator.max_step", 0.0)};
}

Recording recording_of(const Values& v, double end) {
  Recording r;
  r.fields = v.boolean("output.fields");
  r.listed_times = v.numbers("output.times");
  r.field_times = record_times(r.listed_times, number_or(v, "output.interval", 0.0), end);
  r.series_times = record_times(r.field_times, v.number("output.series_interval"), end);
  return r;
}

Checkpointing checkpointing_of(const Values& v, double end, const std::vector<double>& series_times) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const bool by_interval = v.has("checkpoint.interval");
  return {.exact = v.boolean("checkpoint.exact"),
          .times = by_interval ? multiples(v.number("checkpoint.interval"), end, series_times) : std::vector<double>{},
          .by_interval = by_interval,
          .wall_interval = number_or(v, "checkpoint.wall_interval", never),
          .wall_limit = number_or(v, "checkpoint.wall_limit", never)};
}

Scene scene_of(const Values& v) {
  Scene scene;
  scene.name = v.text("scene.name");
  scene.title = v.text("scene.title");
  scene.description = v.text("scene.description");
  scene.box = box_of(v);
  scene.motion = motion_of(v);
  scene.grains = {v.number("grains.rho_star"), v.number("grains.Phi"), v.number("grains.d")};
  scene.regularisation = regularisation_of(v);
  scene.wall = {v.number("wall.mu_w"), v.number("wall.u_c")};
  scene.inflow = inflow_of(v);
  scene.model = v.text("model.name");
  scene.numerics = numerics_of(v);
  scene.two_fluid = two_fluid_of(v);
  scene.initial = initial_of(v, scene);
  scene.left_slope =
      v.has("model.left_slope") ? v.number("model.left_slope") * degree : std::atan(v.number("rheology.mu_s"));
  scene.cells = cells_of(v);
  scene.integration = integration_of(v);
  scene.end = v.number("time.end");
  Problems problems;
  check_together(scene, v, problems);
  try {
    scene.law = law_of(v);
    model(scene.model).check(scene, v, problems);
  } catch (const std::invalid_argument& error) { problems.add(v.place("rheology.law"), "rheology.law", error.what()); }
  problems.throw_if_any();
  scene.recording = recording_of(v, scene.end);
  scene.checkpointing = checkpointing_of(v, scene.end, scene.recording.series_times);
  scene.effective = v.to_toml();
  return scene;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return scene_of(config::read(scene_schema(), file, overrides));
}

Scene read_scene_text(std::string_view toml, const std::string& name, const std::vector<std::string>& overrides) {
  return scene_of(config::read_text(scene_schema(), toml, name, overrides));
}

ida::Options make_integrator_options(const Scene& scene) {
  ida::Options options;
  options.rtol = scene.integration.rtol;
  options.max_order = scene.integration.max_order;
  options.max_step = scene.integration.max_step;
  options.newton.kind = scene.integration.newton;
  options.newton.tolerance = scene.integration.newton_tolerance;
  options.linear.choice = scene.integration.linear_solver;
  return options;
}

}  // namespace talus::app
