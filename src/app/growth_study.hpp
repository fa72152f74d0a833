#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/growth_plan.hpp"
#include "study/growth.hpp"

namespace talus::app {

/// What one disturbance did on one grid.
struct GrowthRun {
  GrowthMember member;
  std::vector<double> times;               ///< [s]
  std::vector<double> amplitudes, others;  ///< root mean square of the disturbed waves, and of all others [m/s]
  double
      taken_over;  ///< when the fit ended early: the disturbance was no longer small, or no longer the disturbed waves' [s]; NaN: never
  study::GrowthFit
      fit;  ///< over the last half of what there is before; no rate where that is shorter than the time of the mode
  std::string end;  ///< why it broke down; "" where it did not
  double reached;   ///< [s]
  int wave;         ///< strongest at the end, in whole waves over the box; 0: none
  double x, z;      ///< where u departed most from its mean along x at the end [m]
};

/// One disturbance on refined grids.
struct GrowthRow {
  std::string name;
  std::vector<GrowthRun> runs;  ///< from the scene's own grid on, cells halved each time
  study::GrowthVerdict verdict;
};

/// What no grid of a study has shown, though theory says so.
struct HiddenGrowth {
  double share;  ///< of the steady layer's thickness in which short waves grow by linear theory
  int cells;  ///< over the thickness, of the coarsest of the symbol's grids on which a wave grows there; 0: none up to the finest
  int most_cells;  ///< of the symbol's finest
};

/// The scene's uniform layer, disturbed, on refined grids.
struct GrowthStudy {
  std::vector<GrowthRow> rows;
  std::optional<HiddenGrowth> hidden;  ///< where the layer is ill-posed in part
  study::GrowthVerdict
      verdict;  ///< of the grid noise; cannot_tell where that decays on every grid though hidden growth is known
};

/// Disturbs the scene's steady layer by one function of x and z, of 1e-6 of its fastest speed, and integrates the full equations (IDA, steps
/// of a twenty-fifth of the fastest disturbed mode's time) for six times of that mode, but at most ten of the grid's fastest: round-off in it then
/// takes over. The members are those of a sweep in the request's folder, so the study resumes. A run that fails is a result. Nothing where a
/// signal ended it. Throws core::ConfigError as SteadyLayer does, core::OutputError where the folder holds another study.
std::optional<GrowthStudy> growth_study(const GrowthRequest& request);

}  // namespace talus::app
