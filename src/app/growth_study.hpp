#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "output/table_file.hpp"
#include "study/growth.hpp"

namespace talus::app {

/// A disturbance on one grid, in time.
struct GrowthRun {
  int columns, layers;
  double predicted;  ///< fastest growth of the waves that fit the box, from the modes of this grid [1/s]
  double duration;   ///< that was to be run [s]
  std::vector<double> times, amplitudes;  ///< [s]; root mean square of what departs from a uniform layer [m/s]
  std::string end;                        ///< why it ended early: a blow-up; "" where it did not
  study::GrowthFit fit;
};

/// The scene's uniform layer with the same small noise on refined grids.
struct GrowthStudy {
  double noise;  ///< of the speeds, at the start [m/s]
  std::uint64_t seed;
  std::vector<GrowthRun> runs;  ///< from the scene's own grid on, cells halved each time
  study::GrowthVerdict verdict;
};

/// Disturbs the scene's uniform steady state by seeded noise of 1e-4 of its fastest speed and integrates the full equations (IDA, steps of a
/// twenty-fifth of the fastest mode's time) for six times of that mode; the rate is fitted over the last three. A run that fails is a
/// result: its time and cause are kept. Runs that lie in `folder`, made from the same scene, are read and not run again. Throws
/// core::ConfigError as SteadyLayer does, core::OutputError where a run cannot be kept.
GrowthStudy growth_study(const Scene& scene, int levels, const std::filesystem::path& folder);

std::string sentence_of(const GrowthStudy& study);
nlohmann::ordered_json json_of(const GrowthStudy& study);
/// Adds variables growth_... along `growth_grid` and `growth_point`.
void add_to(output::Table& table, const GrowthStudy& study);

}  // namespace talus::app
