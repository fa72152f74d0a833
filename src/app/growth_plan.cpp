#include "app/growth_plan.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/refinement.hpp"
#include "app/side_by_side.hpp"
#include "app/steady_layer.hpp"
#include "app/table.hpp"
#include "core/errors.hpp"
#include "modes/plane_waves.hpp"
#include "output/atomic_file.hpp"
#include "output/text_file.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double share = 1e-6;      // of the fastest speed: root mean square of a disturbance on the coarsest grid
constexpr double mode_times = 6.0;  // to run
// But no longer than so many times of the grid's fastest wave of all: round-off in it then overtakes the disturbance.
constexpr double most_times = 10.0;
constexpr int steps_a_time = 25;  // and records
constexpr int ring = 9;           // columns that tell plane waves apart

/// The shortest wave that has a phase: longer than two columns.
int shortest_wave(const Scene& scene) { return (scene.cells.columns - 1) / 2; }

/// To digits that a repeated search for modes gives again.
double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

double rate_of(const modes::PlaneWaves& waves, double phase) {
  const auto found = waves.modes(phase);
  return found.empty() ? none : found.front().rate.real();
}

std::vector<double> sought_rates(const Scene& scene, int jobs) {
  const SteadyLayer steady(scene, ring);
  const modes::PlaneWaves waves(steady.layer(), 0.0, steady.state(), ring);
  std::vector<double> rates(shortest_wave(scene), none);
  side_by_side(rates.size(), jobs, [&](std::size_t i) {
    rates[i] = rate_of(waves, 2.0 * std::numbers::pi * static_cast<double>(i + 1) / scene.cells.columns);
  });
  return rates;
}

GrowthMember member(const Scene& scene, const std::string& name, layer::Disturbance disturbance,
                    const std::vector<double>& rates) {
  double fastest = none;
  for (int m = disturbance.first_wave; m <= disturbance.last_wave; ++m) fastest = std::fmax(fastest, rates.at(m - 1));
  if (!(std::abs(fastest) > 0.0))
    throw core::IntegrationError(fmt::format("study wellposed: no mode was found for {} on {}x{} cells", name,
                                             scene.cells.columns, scene.cells.layers));
  double duration = mode_times / std::abs(fastest), of_all = none;
  for (const double rate : rates) of_all = std::fmax(of_all, rate);
  if (of_all > 0.0) duration = std::min(duration, most_times / of_all);
  return {name, scene.cells.columns, scene.cells.layers, disturbance, fastest, rounded(duration)};
}

template <class Value>
sweep::Axis axis(const std::vector<GrowthMember>& members, const std::string& key, const Value& value) {
  const auto* known = scene_schema().find(key);
  sweep::Axis out{key, known->unit, known->doc, {}};
  for (const auto& member : members) out.values.emplace_back(value(member));
  return out;
}

}  // namespace

Scene refined(Scene scene, int level) {
  for (int i = 0; i < level; ++i) {
    scene.cells.columns *= refinement_ratio;
    scene.cells.layers *= refinement_ratio;
  }
  return scene;
}

std::vector<double> rates_of_waves(const Scene& scene, const std::filesystem::path& folder, int jobs) {
  const auto file = folder / fmt::format("modes_{}x{}.json", scene.cells.columns, scene.cells.layers);
  const auto kept = Json::parse(output::contents(file), nullptr, false);
  std::vector<double> rates;
  if (kept.is_object() && kept.value("scene", "") == scene.effective) {
    for (const auto& rate : kept.at("rates_1_s")) rates.push_back(rate.is_number() ? rate.get<double>() : none);
    return rates;
  }
  std::fprintf(stderr, "modes of the waves on %dx%d cells ...\n", scene.cells.columns, scene.cells.layers);
  rates = sought_rates(scene, jobs);
  Json all = Json::array();
  for (const double rate : rates) all.push_back(json_of(rate));
  output::write_atomically(file, Json{{"scene", scene.effective}, {"rates_1_s", all}}.dump());
  return rates;
}

std::vector<GrowthMember> growth_members(const GrowthRequest& request) {
  const Scene& scene = request.scene;
  const int most = shortest_wave(scene);
  if (scene.model != "layer" || most < 1)
    throw core::ConfigError(
        "study wellposed --parts time: expected model.name = \"layer\" and grid.columns of at least 3");
  for (const int wave : request.waves)
    if (wave < 1 || wave > most)
      throw core::ConfigError(fmt::format(
          "study wellposed --single: expected whole waves over the box from 1 to {}, which {} columns carry, found {}",
          most, scene.cells.columns, wave));
  const auto speeds = SteadyLayer(scene, ring).speeds();
  const double rms = share * std::ranges::max(speeds);
  const std::uint64_t seed = scene.initial.disturbance ? scene.initial.disturbance->seed : 1;
  // Each wave and profile has a root mean square of half its amplitude.
  const double alone = rounded(2.0 * rms / std::sqrt(double(scene.cells.layers))),
               each = rounded(2.0 * rms / std::sqrt(double(most) * scene.cells.layers));
  std::vector<GrowthMember> members;
  for (int level = 0; level < request.levels; ++level) {
    const Scene grid = refined(scene, level);
    const auto rates = rates_of_waves(grid, request.folder, request.jobs);
    members.push_back(member(grid, "noise", {each, 1, most, scene.cells.layers, seed}, rates));
    members.push_back(member(grid, "grid noise", {each, 1, shortest_wave(grid), grid.cells.layers, seed}, rates));
    for (const int wave : request.waves)
      members.push_back(
          member(grid, fmt::format("wave {}", wave), {alone, wave, wave, scene.cells.layers, seed}, rates));
  }
  return members;
}

sweep::Dimension dimension_of(const std::vector<GrowthMember>& members, const Scene& scene) {
  using Integer = std::int64_t;
  using M = GrowthMember;
  const auto constant = [](const auto& value) { return [value](const M&) { return value; }; };
  const auto& its = scene.integration;
  const auto interval = [](const M& m) { return rounded(m.duration / (mode_times * steps_a_time)); };
  sweep::Dimension runs{"growth_run", {}};
  runs.axes = {
      axis(members, "grid.columns", [](const M& m) { return Integer(m.columns); }),
      axis(members, "grid.layers", [](const M& m) { return Integer(m.layers); }),
      axis(members, "disturbance.first_wave", [](const M& m) { return Integer(m.disturbance.first_wave); }),
      axis(members, "disturbance.last_wave", [](const M& m) { return Integer(m.disturbance.last_wave); }),
      axis(members, "disturbance.profiles", [](const M& m) { return Integer(m.disturbance.profiles); }),
      axis(members, "disturbance.speed", [](const M& m) { return m.disturbance.speed; }),
      axis(members, "disturbance.seed", [](const M& m) { return Integer(m.disturbance.seed); }),
      axis(members, "initial.state", constant(std::string("steady"))),
      axis(members, "time.end", [](const M& m) { return m.duration; }),
      axis(members, "output.series_interval", interval), axis(members, "integrator.max_step", interval),
      // Far below the disturbance, which the steps resolve by their length alone: what the solver leaves seeds other waves.
      axis(members, "integrator.rtol", constant(std::min(its.rtol, 1e-9))),
      axis(members, "integrator.atol_velocity", constant(std::min(its.atol_velocity, 1e-11))),
      axis(members, "integrator.atol_pressure", constant(std::min(its.atol_pressure, 1e-7))),
      axis(members, "integrator.atol_height", constant(std::min(its.atol_height, 1e-12)))};
  for (const auto& m : members) runs.labels.push_back(fmt::format("{} on {}x{} cells", m.name, m.columns, m.layers));
  return runs;
}

}  // namespace talus::app
