#include "sweep/runner.hpp"

#include <chrono>
#include <csignal>
#include <deque>

#include "core/errors.hpp"
#include "sweep/process_pool.hpp"
#include "sweep/signal_watch.hpp"

namespace talus::sweep {
namespace {

constexpr double seconds_between_looks = 0.2;
constexpr double seconds_between_manifests = 5.0;

class Runner {
 public:
  Runner(Manifest& manifest, const SweepFolder& folder, const std::vector<std::string>& scenes,
         const RunnerOptions& options, RunnerWatch& watch)
      : manifest_(manifest),
        folder_(folder),
        scenes_(scenes),
        options_(options),
        watch_(watch),
        attempts_(scenes.size(), 0) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const auto& state = manifest_.members[i];
      const bool settled = state.status == Status::failed && !state.goes_on && !options.repeat_failed;
      if (next_action(state) != Action::skip && !settled) queue_.push_back(i);
    }
  }

  int run() {
    while (pool_.running() > 0 || (stopped_by_ == 0 && !queue_.empty())) {
      while (stopped_by_ == 0 && !queue_.empty() && pool_.running() < static_cast<std::size_t>(options_.jobs)) start();
      watch_.idle(pool_.running(), pool_.running() + queue_.size());
      hear(signals_.wait(seconds_between_looks));
      for (const auto& [member, code] : pool_.ended()) end(member, code);
      save_now_and_then();
    }
    write_manifest(folder_.path(), manifest_);
    return stopped_by_;
  }

 private:
  void start() {
    const std::size_t member = queue_.front();
    queue_.pop_front();
    ++attempts_[member];
    const auto run_folder = folder_.path() / folder_.member(member);
    std::filesystem::create_directories(run_folder);
    pool_.start(member, {{options_.program, "member", folder_.path().string(), std::to_string(member)},
                         run_folder / "console.log"});
  }

  void hear(int signal) {
    if (signal == 0 || signal == SIGCHLD) return;
    pool_.send(stopped_by_ == 0 ? SIGTERM : SIGKILL);
    stopped_by_ = signal;
  }

  void end(std::size_t member, int code) {
    MemberState state = member_state(folder_.path() / folder_.member(member), scenes_[member]);
    if (code == static_cast<int>(core::ExitCode::locked)) {
      state.status = Status::unfinished;
      state.reason = "another process is running it";
    } else if (state.exit_code != code) {  // it did not come to write its summary
      state.status = stopped_by_ == 0 ? Status::failed : Status::stopped;
      state.exit_code = code;
      state.reason = "exit code " + std::to_string(code) + ", see " + folder_.member(member) + "/console.log";
    }
    manifest_.members[member] = state;
    const bool again = state.status == Status::failed && attempts_[member] < options_.attempts && stopped_by_ == 0;
    if (again) queue_.push_back(member);
    watch_.ended(member, state, again);
  }

  void save_now_and_then() {
    const auto now = Clock::now();
    if (std::chrono::duration<double>(now - saved_).count() < seconds_between_manifests) return;
    write_manifest(folder_.path(), manifest_);
    saved_ = now;
  }

  using Clock = std::chrono::steady_clock;
  Manifest& manifest_;
  const SweepFolder& folder_;
  const std::vector<std::string>& scenes_;
  const RunnerOptions& options_;
  RunnerWatch& watch_;
  std::vector<int> attempts_;
  std::deque<std::size_t> queue_;
  SignalWatch signals_;  // outlives the pool, whose last children may still end
  ProcessPool pool_;
  int stopped_by_ = 0;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace

Action next_action(const MemberState& state) {
  if (!state.same_scene) return Action::run;
  if (state.status == Status::finished) return Action::skip;
  return state.goes_on ? Action::restart : Action::run;
}

int run_members(Manifest& manifest, const SweepFolder& folder, const std::vector<std::string>& scenes,
                const RunnerOptions& options, RunnerWatch& watch) {
  return Runner(manifest, folder, scenes, options, watch).run();
}

}  // namespace talus::sweep
