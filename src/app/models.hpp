#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "config/problems.hpp"
#include "core/dae_system.hpp"
#include "core/field_source.hpp"

namespace talus::app {

/// A scene made ready to integrate. `fields` reads `system` and must not outlive it.
struct Simulation {
  std::unique_ptr<core::DaeSystem> system;
  std::unique_ptr<core::FieldSource> fields;
};

/// One rung of the ladder that a scene can ask for.
struct Model {
  std::string name;
  std::string doc;          ///< one line
  bool has_columns;         ///< needs `grid.columns`
  bool has_layers = false;  ///< its cells are layers: `grid.layers` and, if it has them, columns part the grains
  bool fixed_grid =
      false;  ///< cells fill the box, which is empty unless an initial thickness is stated; else layers fill the film
  /// Adds to `problems` what of the scene this model cannot represent. The scene need not have its recording yet.
  void (*check)(const Scene& scene, const config::Values& values, config::Problems& problems);
  Simulation (*build)(const Scene& scene);
};

/// Every model that works, by rung.
const std::vector<Model>& models();
/// Precondition: the scene's schema has accepted `name`.
const Model& model(std::string_view name);
std::vector<std::string> model_names();

}  // namespace talus::app
