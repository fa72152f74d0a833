#include "app/driver.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "app/integrator.hpp"
#include "core/errors.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

double seconds_since(std::chrono::steady_clock::time_point moment) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - moment).count();
}

std::vector<double> united(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> both;
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

}  // namespace

Driver::Driver(const Surroundings& surroundings)
    : with_(surroundings),
      integrator_(make_integrator(with_.scene, *with_.simulation.system)),
      progress_(0.0, with_.scene.end, stderr) {}

std::string Driver::run(const output::Checkpoint* checkpoint) {
  begin(checkpoint);
  const double from = integrator_->current().t;
  progress_ = Progress(from, with_.scene.end, stderr);
  for (const double t : united(with_.scene.recording.series_times, with_.scene.checkpointing.times)) {
    if (t <= from) continue;
    if (!reach(t)) {
      progress_.finish();
      const std::string reason = reason_to_stop();
      save_the_end(false);
      with_.recorder.at_end(integrator_->current());
      return reason;
    }
    arrived(t);
  }
  progress_.finish();
  save_the_end(true);
  return "";
}

bool Driver::on_step(const core::Snapshot& snapshot) {
  progress_.show(snapshot);
  return !save_wanted() && reason_to_stop().empty();
}

void Driver::begin(const output::Checkpoint* checkpoint) {
  if (checkpoint != nullptr) {
    integrator_->resume({checkpoint->t, checkpoint->y, checkpoint->yp, checkpoint->statistics},
                        checkpoint->linear_solver);
    return;
  }
  const auto n = static_cast<std::size_t>(with_.simulation.system->layout().size());
  std::vector<double> y(n), yp(n);
  with_.simulation.system->initial_state(0.0, y, yp);
  integrator_->start(0.0, y, yp);
  with_.recorder.at_output(integrator_->current());
}

/// False if the run is to stop before t.
bool Driver::reach(double t) {
  do {
    if (!reason_to_stop().empty()) return false;
    if (save_wanted()) save(true);
  } while (!integrator_->advance(t, *this));
  return true;
}

/// Records and saves what is due at t.
void Driver::arrived(double t) {
  if (std::ranges::binary_search(with_.scene.recording.series_times, t)) {
    const auto now = integrator_->current();
    with_.recorder.at_output(now);
    with_.log.info(
        "t = {:.6g} s: {} steps, {} Newton and {} error test failures, {} factorisations, order {}, step {:.3g} s",
        now.t, now.statistics.steps, now.statistics.newton_failures, now.statistics.error_test_failures,
        now.statistics.factorisations, now.statistics.order, now.statistics.last_step);
  }
  if (std::ranges::binary_search(with_.scene.checkpointing.times, t)) save(t < with_.scene.end);
}

std::string Driver::reason_to_stop() const {
  if (const int signal = with_.interrupt.stop(); signal != 0)
    return std::string("stopped by SIG") + sigabbrev_np(signal);
  const double limit = with_.scene.checkpointing.wall_limit;
  return seconds_since(with_.begun) < limit ? "" : fmt::format("stopped at its wall limit of {:g} s", limit);
}

bool Driver::save_wanted() const {
  return with_.interrupt.save() || seconds_since(last_save_) >= with_.scene.checkpointing.wall_interval;
}

/// Writes a checkpoint of the present state. A run that goes on then starts afresh where checkpoints are exact, through the
/// same door as one that is continued from this checkpoint.
void Driver::save(bool goes_on) {
  const auto now = integrator_->current();
  output::Checkpoint checkpoint;
  checkpoint.t = now.t;
  checkpoint.y.assign(now.y.begin(), now.y.end());
  checkpoint.yp.assign(now.yp.begin(), now.yp.end());
  checkpoint.set_layout(with_.simulation.system->layout());
  checkpoint.statistics = now.statistics;
  checkpoint.linear_solver = integrator_->linear_solver();
  checkpoint.n_records = with_.recorder.bring_to_disk();
  checkpoint.scene = with_.scene.effective;
  checkpoint.summary = with_.summary.state();
  checkpoint.talus_version = output::version();
  checkpoint.revision = output::git_revision();
  with_.folder.check_in_place();
  const std::string file = with_.folder.checkpoints().write(checkpoint);
  with_.summary.saved(now.t);
  with_.log.info("{} at t = {:.6g} s", file, now.t);
  with_.interrupt.answered_save();
  last_save_ = Clock::now();
  if (goes_on && with_.scene.checkpointing.exact) integrator_->resume(now, checkpoint.linear_solver);
}

/// A run that is complete is not spoilt by a checkpoint that nobody may need.
void Driver::save_the_end(bool finished) {
  if (!with_.scene.checkpointing.saves_at_a_stop() || with_.summary.saved() == integrator_->current().t) return;
  try {
    save(false);
  } catch (const core::OutputError& error) {
    if (!finished) throw;
    with_.log.warn("no checkpoint at the end: {}", error.what());
  }
}

}  // namespace talus::app
