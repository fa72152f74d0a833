#include "app/run.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "app/exit_code.hpp"
#include "app/integrator.hpp"
#include "app/interrupt.hpp"
#include "app/models.hpp"
#include "app/progress.hpp"
#include "app/recorder.hpp"
#include "app/run_folder.hpp"
#include "app/summary.hpp"
#include "app/theory.hpp"
#include "app/versions.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"

namespace talus::app {
namespace {

/// Shows progress and passes on a request to stop.
class Watch : public core::Observer {
 public:
  Watch(const Interrupt& interrupt, Progress& progress) : interrupt_(interrupt), progress_(progress) {}
  bool on_step(const core::Snapshot& snapshot) override {
    progress_.show(snapshot);
    return interrupt_.signal() == 0;
  }

 private:
  const Interrupt& interrupt_;
  Progress& progress_;
};

/// A log of its own, flushed at every line, so that a killed run leaves all of it.
std::shared_ptr<spdlog::logger> make_log(const std::filesystem::path& file) {
  try {
    auto log = std::make_shared<spdlog::logger>(
        "run", std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string(), true));
    log->flush_on(spdlog::level::info);
    return log;
  } catch (const spdlog::spdlog_ex& error) { throw core::OutputError(core::ExitCode::io_setup, error.what()); }
}

/// True if it came to the end, false if it was asked to stop.
bool integrate(const Scene& scene, core::Integrator& integrator, const Simulation& simulation, Recorder& recorder,
               const Interrupt& interrupt, spdlog::logger& log) {
  const auto n = static_cast<std::size_t>(simulation.system->layout().size());
  std::vector<double> y(n), yp(n);
  simulation.system->initial_state(0.0, y, yp);
  integrator.start(0.0, y, yp);
  recorder.at_output(integrator.current());
  Progress progress(scene.end, stderr);
  Watch watch(interrupt, progress);
  for (const double t : scene.recording.series_times) {
    if (t == 0.0) continue;
    if (interrupt.signal() != 0 || !integrator.advance(t, watch)) {
      progress.finish();
      return false;
    }
    const auto now = integrator.current();
    recorder.at_output(now);
    log.info("t = {:.6g} s: {} steps, {} Newton and {} error test failures, {} factorisations, order {}, step {:.3g} s",
             now.t, now.statistics.steps, now.statistics.newton_failures, now.statistics.error_test_failures,
             now.statistics.factorisations, now.statistics.order, now.statistics.last_step);
  }
  progress.finish();
  return true;
}

/// Keeps what an early end leaves: the state that was reached, if the disk takes it.
void record_last_state(core::Integrator& integrator, Recorder& recorder, spdlog::logger& log) {
  try {
    recorder.at_end(integrator.current());
  } catch (const std::exception& error) { log.warn("the last state could not be recorded: {}", error.what()); }
}

void write_failure(Summary& summary, const RunFolder& folder, const std::exception& error, spdlog::logger& log) {
  try {
    summary.write(folder.summary(), "failed", exit_code_of(error), error.what());
  } catch (const core::OutputError& second) { log.error("{}", second.what()); }
}

int carry_out(const Scene& scene, const Theory& theory, const RunFolder& folder, const RunRequest& request,
              Summary& summary, spdlog::logger& log) {
  const Interrupt interrupt;
  const Simulation simulation = model(scene.model).build(scene);
  Recorder recorder(scene, theory, *simulation.fields, folder, request.command, summary);
  const auto integrator = make_integrator(scene, *simulation.system);
  bool finished = false;
  try {
    finished = integrate(scene, *integrator, simulation, recorder, interrupt, log);
  } catch (const core::IntegrationError&) {
    summary.integrator(integrator->describe());
    record_last_state(*integrator, recorder, log);
    throw;
  }
  summary.integrator(integrator->describe());
  log.info("{}", integrator->describe());
  if (!finished) record_last_state(*integrator, recorder, log);
  recorder.close();
  constexpr int signal_base = 128;
  const int code = finished ? 0 : signal_base + interrupt.signal();
  const std::string reason = finished ? "" : "stopped by signal " + std::to_string(interrupt.signal());
  summary.write(folder.summary(), finished ? "finished" : "stopped", code, reason);
  log.info("{}", finished ? "finished" : reason);
  std::printf("%s: %s at t = %g s; results in %s\n", scene.name.c_str(), finished ? "finished" : reason.c_str(),
              integrator->current().t, folder.path().c_str());
  return code;
}

}  // namespace

int run(const RunRequest& request) {
  const Scene scene = read_scene(request.scene_file, request.overrides);
  const RunFolder folder(request.out.value_or(std::filesystem::path("out") / scene.name), request.force);
  const Theory theory = theory_of(scene);
  for (const auto& warning : theory.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  output::write_atomically(folder.scene(), scene.effective);
  const auto log = make_log(folder.log());
  log->info("{}", request.command);
  for (const auto& library : library_versions()) log->info("{}", library);
  for (const auto& warning : theory.warnings) log->warn("{}", warning);
  Summary summary(scene, theory.warnings);
  try {
    return carry_out(scene, theory, folder, request, summary, *log);
  } catch (const std::exception& error) {
    log->error("{}", error.what());
    write_failure(summary, folder, error, *log);
    throw;
  }
}

}  // namespace talus::app
