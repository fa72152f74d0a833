#pragma once

#include <chrono>
#include <string>

#include "app/interrupt.hpp"
#include "app/models.hpp"
#include "app/run_folder.hpp"
#include "app/theory.hpp"

namespace talus::app {

/// What `talus run` and `talus restart` have made ready: one stretch of a run.
struct Session {
  const Scene& scene;
  const Theory& theory;
  const Simulation& simulation;
  const RunFolder& folder;
  Interrupt& interrupt;
  std::string command;                             ///< as typed, for the provenance
  std::chrono::steady_clock::time_point begun;     ///< what the wall limit counts from
  const output::Checkpoint* checkpoint = nullptr;  ///< to go on from, else from the start
};

/// Carries it out; leaves run.nc, run.log, checkpoints and, last of all and whatever happens, summary.json. Returns the
/// program's exit code: 0, or 75 for a run that was stopped and can be continued. Throws core::Error and what the model
/// throws, after it has written the summary.
int carry_out(const Session& session);

}  // namespace talus::app
