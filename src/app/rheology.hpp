#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace talus::app {

struct RheologyRequest {
  std::filesystem::path file;
  std::vector<std::string> overrides;
  std::string laws, I, mu, zeta, k;  ///< lists as typed; empty: none
  std::optional<double> thickness;   ///< of Bagnold's flow [m]
  bool json = false;
  std::optional<std::filesystem::path> csv;
};

/// `talus rheology`: a friction law point by point and as a whole. Prints a table or JSON; writes CSV. Throws
/// core::ConfigError on bad input.
void rheology_command(const RheologyRequest& request);

/// Adds the command, its options and its help.
void add_rheology(CLI::App& program);

}  // namespace talus::app
