#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sweep/manifest.hpp"
#include "sweep/sweep_folder.hpp"

namespace talus::sweep {

/// What is to be done with a member.
enum class Action : std::uint8_t { skip, run, restart };
/// Precondition: the run is one of the member's scene, or is to be replaced. Finished ones are skipped; those that can go
/// on do, all others begin anew.
Action next_action(const MemberState& state);

struct RunnerOptions {
  int jobs = 1;               ///< members at a time
  std::string program;        ///< path of talus
  int attempts = 2;           ///< of a member that fails
  bool repeat_failed = true;  ///< also those that failed by themselves before this call
};

/// What the runner tells while it works.
class RunnerWatch {
 public:
  virtual ~RunnerWatch() = default;
  /// `again`: it failed and will be tried once more.
  virtual void ended(std::size_t member, const MemberState& state, bool again) = 0;
  /// Called now and then; `left` are those not ended for good, `running` among them.
  virtual void idle(std::size_t running, std::size_t left) = 0;
};

/// Runs what is not finished, each member as a process of `talus member`; one that fails is tried again when the others are
/// through, unless told otherwise. Keeps `manifest` and, every few seconds, its files up to date. After SIGINT, SIGTERM or SIGHUP the members
/// are asked to stop (SIGTERM) and no other is started; after a second signal they are killed. Returns the signal, or 0.
/// Throws core::OutputError.
/// `scenes[i]` is the effective scene of member i. Preconditions: scenes and manifest are written, the folder is ours
/// alone.
int run_members(Manifest& manifest, const SweepFolder& folder, const std::vector<std::string>& scenes,
                const RunnerOptions& options, RunnerWatch& watch);

}  // namespace talus::sweep
