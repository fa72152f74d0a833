#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "core/field_source.hpp"

namespace talus::app {

/// What a run leaves in summary.json, gathered on the way. Its wall time begins when it is made.
class Summary {
 public:
  Summary(const Scene& scene, const std::vector<std::string>& warnings);

  void integrator(const std::string& description) { json_["integrator"] = description; }
  /// Remembers the integrator's counters and the model's single numbers, `values[i]` of `variables[i]`: those of a
  /// listed output time are kept under "records", the latest under "final".
  void record(const core::Snapshot& snapshot, const std::vector<core::Variable>& variables,
              const std::vector<std::vector<double>>& values, bool listed);
  /// `status` is finished, stopped or failed; `reason` says why, empty if it finished. Put in place in one piece.
  /// Throws core::OutputError(output_failed).
  void write(const std::filesystem::path& path, const std::string& status, int exit_code, const std::string& reason);

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  nlohmann::ordered_json json_;
};

}  // namespace talus::app
