#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "modes/leading_modes.hpp"
#include "output/table_file.hpp"

namespace talus::app {

struct SteadyModesRequest {
  const std::filesystem::path& scene_file;
  const std::vector<std::string>& overrides;
  const Scene& scene;
  const std::filesystem::path& folder;  ///< of the study
  int jobs;
  bool force;
};

/// The leading modes of a scene with ends about its discrete steady state under the full inflow.
struct SteadyModes {
  double time;         ///< to which the steady state belongs [s]
  std::string steady;  ///< how it was found
  int n_columns, n_layers;
  std::vector<double> x, height, height_of_layers;  ///< [m]; the last of cells' middles, shape (layer, column)
  modes::LeadingModes found;                        ///< without those of accumulated masses
  int n_neutral;                                    ///< of which there were so many
  /// Of each kept mode, shape (mode, layer, column): speed's change along the base in cells, and of the surface (mode, column); complex.
  std::vector<std::vector<modes::Complex>> u, p, H;
};

/// Runs the scene to the end of its inflow as a member of a sweep in the folder (so it resumes), finds the steady state from there by
/// KINSOL and its modes by shift-invert Arnoldi. Nothing where a signal ended the run. Throws core::ConfigError for scenes of another model
/// than the layer; core::IntegrationError where there is no steady state to be found.
std::optional<SteadyModes> steady_modes(const SteadyModesRequest& request);

std::string sentence_of(const SteadyModes& study);
nlohmann::ordered_json json_of(const SteadyModes& study);
/// Adds variables mode_... along `mode`, `mode_layer`, `mode_column`.
void add_to(output::Table& table, const SteadyModes& study);

}  // namespace talus::app
