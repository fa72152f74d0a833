#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/member_state.hpp"

namespace talus::sweep {

/// Named numbers at ascending times [s].
struct TimeSeries {
  std::vector<double> times;
  std::map<std::string, std::vector<double>> numbers;  ///< of each name, as long as `times`
};

/// What a run folder holds.
struct MemberResults {
  MemberState state;
  std::map<std::string, double> last;   ///< the model's numbers at the end; empty unless it is finished
  std::map<std::string, double> costs;  ///< counters, seconds and memory, named as in run.nc where that has them
  TimeSeries records;                   ///< the model's numbers at output.times
  TimeSeries series;                    ///< from run.nc
};

/// Reads summary.json, and run.nc for the named series that it has. A folder that holds a run of another scene than
/// `scene` counts as empty. Throws core::OutputError for a run.nc that cannot be read.
MemberResults read_member(const std::filesystem::path& folder, std::string_view scene,
                          const std::vector<std::string>& series);

}  // namespace talus::sweep
