#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/fit_file.hpp"
#include "app/sweep_plan.hpp"
#include "fit/joint.hpp"

namespace talus::app {

/// Runs of a fit's scene, each batch a sweep in a folder of its own: what was run before is read, not run again.
class FitRuns : public fit::LayerRuns {
 public:
  /// `folder`: for all batches. `jobs`: runs at a time, 0: one on each core. `force`: runs of other scenes there are replaced.
  FitRuns(const FitFile& file, std::filesystem::path folder, int jobs, bool force);

  /// Throws core::Error(restartable) after a signal; core::OutputError where the folder cannot be used, holds runs of other scenes, or a run
  /// could not write; core::ConfigError where the scene's model lacks what was measured.
  std::vector<steady::Answer<Eigen::VectorXd>> at(const std::vector<Eigen::VectorXd>& points) override;
  void told(int n_runs, const Eigen::VectorXd& first, double chi2) override;

 private:
  /// The batch as a sweep of the points that the scene accepts, with their numbers.
  [[nodiscard]] sweep::SweepFile sweep_of(const std::vector<Eigen::VectorXd>& points) const;
  [[nodiscard]] std::vector<std::string> settings() const;
  [[nodiscard]] steady::Answer<Eigen::VectorXd> read(const std::filesystem::path& run_folder) const;

  const FitFile& file_;
  const FitLayer& layer_;
  std::filesystem::path folder_;
  int jobs_;
  bool force_;
  int n_batches_ = 0;
};

}  // namespace talus::app
