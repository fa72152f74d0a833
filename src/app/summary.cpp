#include "app/summary.hpp"

#include <sys/resource.h>

#include <algorithm>

#include "app/versions.hpp"
#include "app/well_posedness_words.hpp"
#include "output/atomic_file.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

Json counters(const core::Statistics& s) {
  Json all;
  core::for_each_counter(s, [&](const char* name, auto value) { all[name] = value; });
  return all;
}

std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
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
            {"end_seconds", scene.end},
            {"checkpoint_seconds", nullptr},
            {"continued_from", Json::array()}} {
  json_["records"] = Json::array();
}

void Summary::record(const core::Snapshot& snapshot, const std::vector<core::Variable>& variables,
                     const std::vector<std::vector<double>>& values, bool listed) {
  Json now{{"time", snapshot.t}};
  for (std::size_t i = 0; i < variables.size(); ++i) now[variables[i].name] = values[i].at(0);
  json_["simulated_seconds"] = snapshot.t;
  json_["statistics"] = counters(snapshot.statistics);
  if (listed) json_["records"].push_back(now);
  note_well_posedness(json_["well_posedness"], now);
  json_["final"] = std::move(now);
}

void Summary::continue_from(double t, const std::string& state) {
  const Json before = Json::parse(state);
  for (const char* key : {"records", "final", "statistics", "simulated_seconds", "continued_from", "well_posedness",
                          "wall_seconds", "cpu_seconds", "peak_memory_bytes"})
    if (before.contains(key)) json_[key] = before[key];
  json_["continued_from"].push_back(t);
  saved(t);
}

std::optional<double> Summary::saved() const {
  const auto& t = json_["checkpoint_seconds"];
  return t.is_null() ? std::nullopt : std::optional(t.get<double>());
}

nlohmann::ordered_json Summary::with_times() const {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  Json json = json_;
  const auto add = [&](const char* key, double now) { json[key] = json_.value(key, 0.0) + now; };
  add("wall_seconds", std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count());
  add("cpu_seconds", seconds(usage.ru_utime) + seconds(usage.ru_stime));
  json["peak_memory_bytes"] =
      std::max(json_.value("peak_memory_bytes", std::int64_t{0}), static_cast<std::int64_t>(usage.ru_maxrss) * 1024);
  return json;
}

std::string Summary::well_posedness() const {
  return json_.contains("final") ? well_posedness_words(json_.value("well_posedness", Json()), json_["final"]) : "";
}

std::string Summary::state() const { return text_of(with_times(), -1); }

void Summary::write(const std::filesystem::path& path, const std::string& status, int exit_code,
                    const std::string& reason) {
  json_["status"] = status;
  json_["exit_code"] = exit_code;
  json_["reason"] = reason.empty() ? Json(nullptr) : Json(reason);
  const auto words = well_posedness();
  json_["well_posedness_verdict"] = words.empty() ? Json(nullptr) : Json(words);
  output::write_atomically(path, text_of(with_times(), 2) + "\n");
}

}  // namespace talus::app
