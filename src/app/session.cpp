#include "app/session.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "app/driver.hpp"
#include "app/exit_code.hpp"
#include "app/versions.hpp"
#include "core/errors.hpp"

namespace talus::app {
namespace {

/// A log of its own, flushed at every line, so that a killed run leaves all of it; a continued run adds to it.
std::shared_ptr<spdlog::logger> make_log(const std::filesystem::path& file) {
  try {
    auto log = std::make_shared<spdlog::logger>(
        "run", std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string(), false));
    log->flush_on(spdlog::level::info);
    return log;
  } catch (const spdlog::spdlog_ex& error) { throw core::OutputError(core::ExitCode::io_setup, error.what()); }
}

/// Where `talus restart` would go on, and how to ask for it.
std::string way_on(const Session& session, const Summary& summary) {
  const auto t = summary.saved();
  return "`" + session.folder.restart_command() + "` " +
         (t ? fmt::format("goes on from t = {:.6g} s", *t) : "begins anew: there is no checkpoint yet");
}

/// Keeps what a failure leaves: the state that was reached, if the disk takes it.
void record_last_state(const core::Integrator& integrator, Recorder& recorder, spdlog::logger& log) {
  try {
    recorder.at_end(integrator.current());
  } catch (const std::exception& error) { log.warn("the last state could not be recorded: {}", error.what()); }
}

void write_failure(const Session& session, Summary& summary, const std::exception& error, spdlog::logger& log) {
  try {
    session.folder.check_in_place();
    summary.write(session.folder.summary(), "failed", exit_code_of(error), words_of(error));
  } catch (const core::OutputError& second) {
    log.error("{}", second.what());
    std::fprintf(stderr, "talus: %s\n", second.what());
  }
}

int integrate(const Session& session, Summary& summary, spdlog::logger& log) {
  Recorder recorder(session.scene, session.theory, *session.simulation.fields, session.folder, session.command, summary,
                    session.checkpoint);
  Driver driver(
      {session.scene, session.simulation, session.folder, session.interrupt, recorder, summary, log, session.begun});
  std::string reason;
  try {
    reason = driver.run(session.checkpoint);
  } catch (const core::IntegrationError&) {
    summary.integrator(driver.integrator().describe());
    record_last_state(driver.integrator(), recorder, log);
    throw;
  }
  const bool finished = reason.empty();
  const double t = driver.integrator().current().t;
  if (!finished) reason += fmt::format(" at t = {:.6g} s; {}", t, way_on(session, summary));
  summary.integrator(driver.integrator().describe());
  log.info("{}", driver.integrator().describe());
  recorder.close();
  const int code = finished ? 0 : static_cast<int>(core::ExitCode::restartable);
  session.folder.check_in_place();
  summary.write(session.folder.summary(), finished ? "finished" : "stopped", code, reason);
  log.info("{}", finished ? "finished" : reason);
  if (finished) reason = fmt::format("finished at t = {:g} s; results in {}", t, session.folder.path().string());
  std::printf("%s: %s\n", session.scene.name.c_str(), reason.c_str());
  if (const auto words = summary.well_posedness(); !words.empty()) {
    log.info("{}", words);
    std::printf("%s: %s\n", session.scene.name.c_str(), words.c_str());
  }
  return code;
}

}  // namespace

int carry_out(const Session& session) {
  const auto log = make_log(session.folder.log());
  log->info("{}", session.command);
  for (const auto& library : library_versions()) log->info("{}", library);
  for (const auto& warning : session.theory.warnings) log->warn("{}", warning);
  Summary summary(session.scene, session.theory.warnings);
  if (session.checkpoint != nullptr) {
    summary.continue_from(session.checkpoint->t, session.checkpoint->summary);
    log->info("goes on from the checkpoint at t = {:.6g} s", session.checkpoint->t);
  }
  try {
    return integrate(session, summary, *log);
  } catch (const std::exception& error) {
    log->error("{}", words_of(error));
    log->info("{}", way_on(session, summary));
    write_failure(session, summary, error, *log);
    if (summary.saved()) std::fprintf(stderr, "%s: %s\n", session.scene.name.c_str(), way_on(session, summary).c_str());
    throw;
  }
}

}  // namespace talus::app
