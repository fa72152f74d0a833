#include "sweep/member_results.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "output/run_reader.hpp"
#include "output/text_file.hpp"

namespace talus::sweep {
namespace {

using Json = nlohmann::json;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The numbers of an object by name; null is a number that has no value.
std::map<std::string, double> numbers_in(const Json& object) {
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : object.items()) {
    if (value.is_number() || value.is_null()) numbers[name] = value.is_null() ? missing : value.get<double>();
  }
  return numbers;
}

Json part(const Json& summary, const char* name) {
  const auto found = summary.find(name);
  return found == summary.end() ? Json() : *found;
}

TimeSeries records_of(const Json& summary) {
  TimeSeries records;
  for (const auto& record : part(summary, "records")) {
    auto numbers = numbers_in(record);
    records.times.push_back(numbers["time"]);
    numbers.erase("time");
    for (const auto& [name, value] : numbers) {
      auto& all = records.numbers[name];
      all.resize(records.times.size(), missing);
      all.back() = value;
    }
  }
  for (auto& [name, all] : records.numbers) all.resize(records.times.size(), missing);
  return records;
}

/// Counters of steps and the like are called n_... in run.nc.
std::map<std::string, double> costs_of(const Json& summary) {
  std::map<std::string, double> costs;
  for (const auto& [name, value] : numbers_in(part(summary, "statistics")))
    costs[name.starts_with("cpu_") ? name : "n_" + name] = value;
  for (const char* name : {"simulated_seconds", "wall_seconds", "cpu_seconds", "peak_memory_bytes"}) {
    if (const auto value = part(summary, name); value.is_number()) costs[name] = value.get<double>();
  }
  return costs;
}

}  // namespace

MemberResults read_member(const std::filesystem::path& folder, std::string_view scene,
                          const std::vector<std::string>& series) {
  MemberResults results;
  const MemberState state = member_state(folder, scene);
  if (!state.same_scene) return results;
  results.state = state;
  const auto summary = Json::parse(output::contents(folder / "summary.json"), nullptr, false);
  if (summary.is_object()) {
    if (results.state.status == Status::finished) results.last = numbers_in(part(summary, "final"));
    results.last.erase("time");
    results.costs = costs_of(summary);
    results.records = records_of(summary);
  }
  if (series.empty() || !std::filesystem::exists(folder / "run.nc")) return results;
  const output::RunReader run(folder / "run.nc");
  results.series.times = run.values("series_time");
  for (const auto& name : series) {
    if (std::ranges::find(run.series(), name) != run.series().end()) results.series.numbers[name] = run.values(name);
  }
  return results;
}

}  // namespace talus::sweep
