#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace talus::support {

/// Three members of a small sweep.
inline const std::string angles = "[[axis]]\nkey = \"box.tilt\"\nvalues = [40, 42, 45]\n";

/// A sweep over a chute of 4 x 8 cells that runs for two hundredths of a second, in a folder whose name asks for quotes.
/// `settings`: of all members in place of these, as the sweep file lists them.
/// Needs the compile definitions TALUS_PROGRAM and TALUS_SOURCE_DIR.
class SmallSweep {
 public:
  explicit SmallSweep(const std::string& axes,
                      const std::string& settings = "\"time.end=0.02\", \"output.times=[0.01]\"") {
    std::ofstream(folder_ / "s.toml") << "[sweep]\nname = \"s\"\ntitle = \"small\"\nscene = \"" TALUS_SOURCE_DIR
                                      << "/runs/examples/chute_periodic.toml\"\nset = [\"grid.layers=8\", " << settings
                                      << "]\n"
                                      << axes;
  }
  [[nodiscard]] std::filesystem::path folder() const { return folder_ / "it's a \"sweep\" $(touch x)"; }
  /// The words after `talus` that run it, further options last.
  [[nodiscard]] std::vector<std::string> command(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"sweep", (folder_ / "s.toml").string(), "--out", folder().string()});
    return more;
  }
  [[nodiscard]] Outcome sweep(const std::vector<std::string>& more = {}) const {
    return outcome_of(TALUS_PROGRAM, command(more));
  }
  /// The words after `talus` that run one member.
  [[nodiscard]] std::vector<std::string> member_command(int member) const {
    return {"member", folder().string(), std::to_string(member)};
  }
  [[nodiscard]] std::filesystem::path member(int number) const {
    return folder() / "members" / ("000" + std::to_string(number));
  }
  [[nodiscard]] nlohmann::json summary(int number) const {
    return nlohmann::json::parse(contents(member(number) / "summary.json"));
  }
  [[nodiscard]] bool finished(int number) const {
    return std::filesystem::exists(member(number) / "summary.json") && summary(number)["status"] == "finished";
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace talus::support
