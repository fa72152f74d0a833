#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/growth_study.hpp"
#include "app/symbol_study.hpp"

namespace talus::app {

/// What `talus study wellposed` says of the scene as a whole.
struct WellposedVerdict {
  std::string word;                ///< "convergent", "not convergent", "blows up" or "cannot tell"
  std::optional<double> exponent;  ///< n of a rate as k^n
  std::string grid;                ///< that may tell where these cannot, "64x96"; "" where it is not asked for
  std::string by;                  ///< what it rests on
};

/// By the grids of disturbances in time.
WellposedVerdict verdict_of(const GrowthStudy& study);
/// By the symbol, at the inertial numbers up to `most`, the largest of the scene's steady flow, or at all; nothing where it has none of those.
std::optional<WellposedVerdict> verdict_of(const SymbolStudy& study, std::optional<double> most);

/// "Verdict: blows up with a rate as k^2.00, by ...."
std::string sentence_of(const WellposedVerdict& verdict);
nlohmann::ordered_json json_of(const WellposedVerdict& verdict);

}  // namespace talus::app
