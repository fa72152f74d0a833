#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace talus::support {

/// A sweep over a chute of 4 x 8 cells that runs for two hundredths of a second, in a folder whose name asks for quotes.
/// Needs the compile definitions TALUS_PROGRAM and TALUS_SOURCE_DIR.
class SmallSweep {
 public:
  explicit SmallSweep(const std::string& axes) {
    std::ofstream(folder_ / "s.toml") << "[sweep]\nname = \"s\"\ntitle = \"small\"\nscene = \"" TALUS_SOURCE_DIR
                                      << "/runs/examples/chute_periodic.toml\"\nset = [\"grid.layers=8\", "
                                         "\"time.end=0.02\", \"output.times=[0.01]\"]\n"
                                      << axes;
  }
  [[nodiscard]] std::filesystem::path folder() const { return folder_ / "it's a \"sweep\" $(touch x)"; }
  [[nodiscard]] Outcome sweep(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"sweep", (folder_ / "s.toml").string(), "--out", folder().string()});
    return outcome_of(TALUS_PROGRAM, more);
  }
  [[nodiscard]] nlohmann::json summary(int member) const {
    return nlohmann::json::parse(contents(folder() / "members" / ("000" + std::to_string(member)) / "summary.json"));
  }
  [[nodiscard]] bool finished(int member) const {
    const auto file = folder() / "members" / ("000" + std::to_string(member)) / "summary.json";
    return std::filesystem::exists(file) && summary(member)["status"] == "finished";
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace talus::support
