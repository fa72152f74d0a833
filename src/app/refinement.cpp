#include "app/refinement.hpp"

#include <cmath>
#include <sstream>

#include "app/models.hpp"
#include "core/errors.hpp"

namespace talus::app {
namespace {

Refinement grid_of(const Scene& scene) {
  const auto& its = model(scene.model);
  return {.x = its.has_columns && its.has_layers, .z = its.has_layers, .t = false};
}

sweep::Axis axis(const std::string& key) {
  const auto* known = scene_schema().find(key);
  return {key, known->unit, known->doc, {}};
}

sweep::Axis refined(const std::string& key, int coarsest, int n) {
  auto out = axis(key);
  std::int64_t cells = coarsest;
  for (int level = 0; level < n; ++level, cells *= refinement_ratio) out.values.emplace_back(cells);
  return out;
}

sweep::Axis divided(const std::string& key, double coarsest, int ratio, int n) {
  auto out = axis(key);
  for (int level = 0; level < n; ++level) out.values.emplace_back(coarsest / std::pow(ratio, level));
  return out;
}

}  // namespace

std::string Refinement::words() const {
  std::string out;
  for (const auto& [taken, letter] : {std::pair{x, "x"}, {z, "z"}, {t, "t"}}) {
    if (taken) out += (out.empty() ? "" : ", ") + std::string(letter);
  }
  return out;
}

Refinement refinement_of(const std::optional<std::string>& directions, const Scene& scene) {
  const Refinement possible = grid_of(scene);
  if (!directions) return {possible.x, possible.z, !possible.x && !possible.z};
  const std::string all = Refinement{possible.x, possible.z, true}.words();
  Refinement out{};
  std::istringstream list(*directions);
  for (std::string letter; std::getline(list, letter, ',');) {
    const auto refuse = [&](const std::string& why) {
      throw core::ConfigError("study converge --in " + *directions + ": " + why + "; expected some of " + all +
                              ", with commas between them");
    };
    if (letter == "x") out.x = true;
    else if (letter == "z") out.z = true;
    else if (letter == "t") out.t = true;
    else refuse("\"" + letter + "\" is no direction");
    if ((letter == "x" && !possible.x) || (letter == "z" && !possible.z))
      refuse("the " + scene.model + " model has no cells along " + letter);
  }
  if (!out.x && !out.z && !out.t) throw core::ConfigError("study converge --in: expected some of " + all);
  return out;
}

sweep::Dimension levels_of(const Scene& scene, const Refinement& refinement, int n) {
  sweep::Dimension levels{"level", {}};
  if (refinement.x) levels.axes.push_back(refined("grid.columns", scene.cells.columns, n));
  if (refinement.z) levels.axes.push_back(refined("grid.layers", scene.cells.layers, n));
  if (refinement.t) {
    const auto& its = scene.integration;
    levels.axes.push_back(divided("integrator.rtol", its.rtol, tolerance_ratio, n));
    levels.axes.push_back(divided("integrator.atol_velocity", its.atol_velocity, tolerance_ratio, n));
    levels.axes.push_back(divided("integrator.atol_pressure", its.atol_pressure, tolerance_ratio, n));
    levels.axes.push_back(divided("integrator.atol_height", its.atol_height, tolerance_ratio, n));
    levels.axes.push_back(divided("integrator.atol_mass", its.atol_mass, tolerance_ratio, n));
    if (its.max_step > 0.0) levels.axes.push_back(divided("integrator.max_step", its.max_step, refinement_ratio, n));
  }
  return levels;
}

}  // namespace talus::app
