#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/trade_choices.hpp"
#include "study/trade.hpp"
#include "sweep/manifest.hpp"

namespace talus::app {

/// What a choice came to.
struct TradeRow {
  TradeChoice choice;
  sweep::MemberState state;
  std::map<std::string, double> costs;  ///< counters, seconds and memory, as sweep::MemberResults has them
  std::map<std::string, double>
      errors;  ///< of each number, in its unit: the largest difference from the reference over the times
               ///< at which both have it; empty unless both finished
  std::optional<double> exact_error;  ///< of the slope of a steady heap against the exact one [degree]
  [[nodiscard]] double cost() const;  ///< CPU seconds; NaN where there are none
};

/// A number of the model by which choices are judged.
struct TradeNumber {
  std::string name, unit, long_name;
  double scale;  ///< the largest value of the reference over the times
  double
      uncertainty;  ///< of the reference itself, by the scene's own ladder of grids, in its unit; NaN where that tells nothing
};

/// The exact slope of the steady heap, and the listed time at which the heap is held against it.
struct ExactSlope {
  double time;     ///< [s]
  double degrees;  ///< of grains as the scene states them, without its regularisations
};

struct TradeStudy {
  std::vector<TradeRow> rows;  ///< in the order of the choices
  std::vector<TradeNumber> numbers;
  std::string judge;                ///< name of the number that orders the choices
  std::optional<ExactSlope> exact;  ///< where the reference is steady at that time
  std::vector<std::string> left_out;
  std::optional<double> growth;  ///< exponent of CPU against cells, over the grids of the group "grid" and the scene

  [[nodiscard]] const TradeNumber& judged() const;
  /// Cost and error of each row by `judge`, the error relative to its scale; NaN where there is none. The reference has none.
  [[nodiscard]] std::vector<study::Priced> priced() const;
  /// The same by the exact slope [degree], the reference included.
  [[nodiscard]] std::vector<study::Priced> priced_by_slope() const;
};

/// The last listed time at which the inflow is at its full rate and the heap's steady slope is known.
std::optional<ExactSlope> exact_slope_of(const Scene& scene);

/// Reads the members of a study. `by`: the number that judges; without one heap_angle, mass_flow or mass_stored, whichever the model
/// has. Throws core::ConfigError where the reference has no number `by`, or did not finish; core::OutputError for a run.nc that cannot be read.
TradeStudy read_trade_study(const std::filesystem::path& folder, const sweep::Manifest& manifest, const Scene& scene,
                            const TradeChoices& choices, const std::optional<std::string>& by);

}  // namespace talus::app
