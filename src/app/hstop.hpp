#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace talus::app {

/// One source of the curve (A2), and what else appendix A needs.
struct HstopRequest {
  std::filesystem::path data;  ///< measurements, to be fitted: columns zeta_deg, h_stop_m; or
  std::string curve;           ///< mu_s,mu_d,L; or
  std::filesystem::path law;   ///< scene or material file with mu_s, mu_d, I_0, and the grains
  std::vector<std::string> overrides;
  double beta = 0.0, d = 0.0, Phi = 0.0;  ///< 0: not given
  std::string zeta;                       ///< angles [degree] of a table of h_stop
  bool json = false;
  std::filesystem::path csv;
};

/// `talus hstop`: from deposits on a rough plane to the classical law and back. Throws core::ConfigError on bad input.
void hstop_command(const HstopRequest& request);

/// Adds the command, its options and its help.
void add_hstop(CLI::App& program);

}  // namespace talus::app
