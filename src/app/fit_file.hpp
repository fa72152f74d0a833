#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/schema.hpp"
#include "fit/problem.hpp"

namespace talus::app {

/// Every key of a fit file.
const config::Schema& fit_schema();

/// The second stage of a fit: what its runs are of.
struct FitLayer {
  std::filesystem::path scene;
  std::vector<std::string> settings;  ///< "key=value", for every run
  std::vector<std::string> keys;      ///< of the scene, one an unknown: those of the steady flow, then the layer's own
  fit::LayerStage stage;
};

/// A fit file as objects.
struct FitFile {
  std::string name, title;
  fit::Problem problem;                    ///< `predict` holds the flows held back
  std::vector<fit::SlopePoint> held_back;  ///< measured at those flows, and left out of the fit
  std::optional<FitLayer> layer{};
};

/// Reads a fit file and the material and data files that it names, found from its own folder; `overrides` as
/// `config::read`. Throws core::ConfigError naming file, line, column and key of whatever is wrong.
FitFile read_fit(const std::filesystem::path& file, const std::vector<std::string>& overrides);

}  // namespace talus::app
