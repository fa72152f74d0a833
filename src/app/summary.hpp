#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "core/field_source.hpp"

namespace talus::app {

/// What a run leaves in summary.json, gathered on the way. Its wall time begins when it is made. Wall and CPU time of a
/// continued run count what led to the checkpoint, too.
class Summary {
 public:
  Summary(const Scene& scene, const std::vector<std::string>& warnings);

  void integrator(const std::string& description) { json_["integrator"] = description; }
  /// Goes on from what state() gave at time t [s].
  void continue_from(double t, const std::string& state);
  /// What has been gathered up to now, times of this process included.
  [[nodiscard]] std::string state() const;
  /// A checkpoint at time t [s] is on disk.
  void saved(double t) { json_["checkpoint_seconds"] = t; }
  /// Time of the last checkpoint [s], if there is one.
  [[nodiscard]] std::optional<double> saved() const;
  /// Remembers the integrator's counters and the model's single numbers, `values[i]` of `variables[i]`: those of a
  /// listed output time are kept under "records", the latest under "final".
  void record(const core::Snapshot& snapshot, const std::vector<core::Variable>& variables,
              const std::vector<std::vector<double>>& values, bool listed);
  /// How close the run came to ill-posedness, for people; empty where the model does not say.
  [[nodiscard]] std::string well_posedness() const;
  /// `status` is finished, stopped or failed; `reason` says why, empty if it finished. Put in place in one piece.
  /// Throws core::OutputError(output_failed).
  void write(const std::filesystem::path& path, const std::string& status, int exit_code, const std::string& reason);

 private:
  [[nodiscard]] nlohmann::ordered_json with_times() const;

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  nlohmann::ordered_json json_;
};

}  // namespace talus::app
