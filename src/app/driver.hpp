#pragma once

#include <spdlog/logger.h>

#include <chrono>
#include <memory>
#include <string>

#include "app/interrupt.hpp"
#include "app/models.hpp"
#include "app/progress.hpp"
#include "app/recorder.hpp"
#include "app/run_folder.hpp"
#include "app/scene.hpp"
#include "app/summary.hpp"
#include "output/checkpoint.hpp"

namespace talus::app {

/// Takes a run from its start, or from a checkpoint, to its end: integrates, has records written, writes checkpoints, stops
/// where a signal or the wall limit asks for it. Wall time is the steady clock's: setting the clock changes nothing.
class Driver final : public core::Observer {
 public:
  struct Surroundings {
    const Scene& scene;
    const Simulation& simulation;
    const RunFolder& folder;
    Interrupt& interrupt;
    Recorder& recorder;
    Summary& summary;
    spdlog::logger& log;
    std::chrono::steady_clock::time_point begun;  ///< what the wall limit counts from
  };

  /// All must outlive this.
  explicit Driver(const Surroundings& surroundings);

  /// Integrates from the start, or from `checkpoint`. Returns "" at the end, or why it stopped before. Throws what the
  /// integrator, the recorder and the checkpoints throw.
  std::string run(const output::Checkpoint* checkpoint);

  [[nodiscard]] const core::Integrator& integrator() const { return *integrator_; }

  bool on_step(const core::Snapshot& snapshot) override;

 private:
  using Clock = std::chrono::steady_clock;

  void begin(const output::Checkpoint* checkpoint);
  bool reach(double t);
  void arrived(double t);
  [[nodiscard]] std::string reason_to_stop() const;
  [[nodiscard]] bool save_wanted() const;
  void save(bool goes_on);
  void save_the_end(bool finished);

  Surroundings with_;
  std::unique_ptr<core::Integrator> integrator_;
  Progress progress_;
  Clock::time_point last_save_ = Clock::now();
};

}  // namespace talus::app
