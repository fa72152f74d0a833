#pragma once

#include "app/exact_profile.hpp"
#include "app/run_folder.hpp"
#include "app/scene.hpp"
#include "app/selected_fields.hpp"
#include "app/summary.hpp"
#include "app/theory.hpp"
#include "output/combined_fields.hpp"
#include "output/run_file.hpp"
#include "output/statistics_fields.hpp"

namespace talus::app {

/// Writes a run's records: fields along `time`; surface lines, single numbers and statistics along `series_time`. The
/// numbers also go to the summary.
class Recorder {
 public:
  /// Creates run.nc, or goes on with the records that belong to the checkpoint `from`, if any. All arguments but `from`
  /// must outlive this. Throws core::OutputError.
  Recorder(const Scene& scene, const Theory& theory, core::FieldSource& model, const RunFolder& folder,
           const std::string& command, Summary& summary, const output::Checkpoint* from);

  /// Records at a series time; fields too if it is one of their times. Throws core::OutputError(output_failed).
  void at_output(const core::Snapshot& snapshot);
  /// Records everything, whatever the time: the last state of a run that ends early.
  void at_end(const core::Snapshot& snapshot);
  /// Records in each stream, all of them on disk when this returns. Throws core::OutputError(output_failed).
  [[nodiscard]] std::vector<std::size_t> bring_to_disk();
  /// Throws core::OutputError(output_failed).
  void close() { file_.close(); }

 private:
  void series(const core::Snapshot& snapshot, bool listed);

  const Recording& recording_;
  Summary& summary_;
  EvaluatedFields model_;
  SelectedFields fields_;
  ExactProfile exact_;
  output::CombinedFields fields_and_exact_;
  SelectedFields numbers_;
  SelectedFields lines_;
  output::StatisticsFields statistics_;
  output::CombinedFields series_;
  output::RunFile file_;
  std::size_t series_stream_;
  double last_ = -1.0;
  std::vector<std::vector<double>> values_;
};

}  // namespace talus::app
