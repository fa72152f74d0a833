#include "app/summary.hpp"

#include <sys/resource.h>

#include "app/versions.hpp"
#include "output/atomic_file.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

Json counters(const core::Statistics& s) {
  return {{"steps", s.steps},
          {"error_test_failures", s.error_test_failures},
          {"newton_failures", s.newton_failures},
          {"newton_iterations", s.newton_iterations},
          {"residuals", s.residuals},
          {"jacobians", s.jacobians},
          {"factorisations", s.factorisations},
          {"solves", s.solves},
          {"inadmissible_states", s.inadmissible_states},
          {"restarts", s.restarts},
          {"cpu_residual", s.seconds_residual},
          {"cpu_jacobian", s.seconds_jacobian},
          {"cpu_factor", s.seconds_factor},
          {"cpu_solve", s.seconds_solve}};
}

}  // namespace

Summary::Summary(const Scene& scene, const std::vector<std::string>& warnings)
    : json_{{"status", nullptr},
            {"exit_code", nullptr},
            {"reason", nullptr},
            {"scene", scene.name},
            {"title", scene.title},
            {"model", scene.model},
            {"talus_version", output::version()},
            {"git_revision", output::git_revision()},
            {"libraries", library_versions()},
            {"warnings", warnings},
            {"simulated_seconds", 0.0},
            {"end_seconds", scene.end}} {
  json_["records"] = Json::array();
}

void Summary::record(const core::Snapshot& snapshot, const std::vector<core::Variable>& variables,
                     const std::vector<std::vector<double>>& values, bool listed) {
  Json now{{"time", snapshot.t}};
  for (std::size_t i = 0; i < variables.size(); ++i) now[variables[i].name] = values[i].at(0);
  json_["simulated_seconds"] = snapshot.t;
  json_["statistics"] = counters(snapshot.statistics);
  if (listed) json_["records"].push_back(now);
  json_["final"] = std::move(now);
}

void Summary::write(const std::filesystem::path& path, const std::string& status, int exit_code,
                    const std::string& reason) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  json_["status"] = status;
  json_["exit_code"] = exit_code;
  json_["reason"] = reason.empty() ? Json(nullptr) : Json(reason);
  json_["wall_seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  json_["cpu_seconds"] = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  json_["peak_memory_bytes"] = static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
  output::write_atomically(path, json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace talus::app
