#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::app {

struct TradeRequest {
  std::filesystem::path scene_file;
  std::vector<std::string> overrides;        ///< "key=value"
  std::optional<std::filesystem::path> out;  ///< else out/<scene name>_trade
  std::optional<std::string> by;             ///< the number that judges
  int jobs = 1;                              ///< members at a time
  bool force = false;                        ///< run choices again whose scene has changed
  std::string command;                       ///< as typed, for the provenance
};

/// `talus study trade`: the scene by every choice of trade_choices, each a member of a sweep; then study.nc, trade.csv, verdict.json and
/// study.png in its folder and a table on the terminal. Returns the program's exit code: 0 where all members ended, failed
/// ones being rows of the table; restartable after a signal. Throws core::Error.
int study_trade(const TradeRequest& request);

}  // namespace talus::app
