#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/fit_file.hpp"
#include "app/table.hpp"
#include "fit/fit.hpp"

namespace talus::app {

/// A table of a fit's answer, with the sentence that stands over it.
struct FitSection {
  std::string name, heading;
  Table table;
};

/// All that a fit tells, once: text, JSON and netCDF are forms of it.
[[nodiscard]] std::vector<FitSection> fit_sections(const FitFile& file, const fit::Fit& fit);

/// Slope against flow of the best model, for pictures: over the flows measured and a third beyond.
[[nodiscard]] FitSection slope_curve(const FitFile& file, const fit::Fit& fit);
/// Speeds of the best model in each profile, for pictures, from its surface to where the deepest datum lies.
[[nodiscard]] FitSection speed_curves(const FitFile& file, const fit::Fit& fit);

/// For people; `fit` may be the reason why there is none.
[[nodiscard]] std::string fit_text(const FitFile& file, const steady::Answer<fit::Fit>& fit);
[[nodiscard]] nlohmann::ordered_json fit_json(const FitFile& file, const steady::Answer<fit::Fit>& fit);
/// `<section>_<column>` along a dimension of the section's name.
void write_fit_file(const std::filesystem::path& path, const FitFile& file, const fit::Fit& fit,
                    const std::string& command);

}  // namespace talus::app
