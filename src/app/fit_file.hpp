#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/schema.hpp"
#include "fit/problem.hpp"

namespace talus::app {

/// Every key of a fit file.
const config::Schema& fit_schema();

/// A fit file as objects.
struct FitFile {
  std::string name, title;
  fit::Problem problem;                    ///< `predict` holds the flows held back
  std::vector<fit::SlopePoint> held_back;  ///< measured at those flows, and left out of the fit
};

/// Reads a fit file and the material and data files that it names, found from its own folder; `overrides` as
/// `config::read`. Throws core::ConfigError naming file, line, column and key of whatever is wrong.
FitFile read_fit(const std::filesystem::path& file, const std::vector<std::string>& overrides);

}  // namespace talus::app
