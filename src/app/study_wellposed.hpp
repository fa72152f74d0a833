#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::app {

struct WellposedRequest {
  std::filesystem::path scene_file;
  std::vector<std::string> overrides;        ///< "key=value"
  std::optional<std::filesystem::path> out;  ///< else out/<scene name>_wellposed
  std::vector<std::string> parts;            ///< "symbol", "modes", "time"; none: the first two
  std::string I = "1e-6:1e4:x41";            ///< of the symbol, see number_list
  int most_cells = 1024;                     ///< of the symbol's finest grid, a power of 2, at least 16
  int waves = 32;                            ///< wavelengths of a uniform layer's modes
  int levels = 4;                            ///< grids of disturbances in time
  std::vector<int> single;  ///< waves over the box disturbed alone; none: 1 and a quarter of the columns
  int jobs = 0;
  bool force = false;   ///< run again what was run of another scene
  std::string command;  ///< as typed, for the provenance
};

/// `talus study wellposed`: the Fourier symbol of the operator, the modes of the discrete steady state, and noise on
/// refined grids in time; study.nc, verdict.json and study.png
/// in the study's folder, the verdict in words on the terminal. Returns the program's exit code: 0 whatever the verdict; restartable
/// after a signal. Throws core::Error.
int study_wellposed(const WellposedRequest& request);

}  // namespace talus::app
