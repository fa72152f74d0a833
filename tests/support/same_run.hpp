#pragma once

#include <netcdf.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "support/nc_reader.hpp"
#include "support/program.hpp"

namespace talus::support {

inline bool is_cpu_time(const std::string& name) { return name.starts_with("cpu_"); }

/// Names of a file's variables, without CPU times: no two runs agree on those.
inline std::set<std::string> variables_of(const NcReader& run) {
  int n = 0;
  nc_inq_nvars(run.file(), &n);
  std::set<std::string> names;
  for (int id = 0; id < n; ++id) {
    char text[NC_MAX_NAME + 1];
    nc_inq_varname(run.file(), id, text);
    if (!is_cpu_time(text)) names.insert(text);
  }
  return names;
}

/// What differs, bit by bit, between the results of two runs: variables of run.nc, numbers of summary.json. "" for nothing.
inline std::string differences_between(const std::filesystem::path& a, const std::filesystem::path& b) {
  const NcReader first(a / "run.nc"), second(b / "run.nc");
  std::string words;
  if (variables_of(first) != variables_of(second)) words += "other variables; ";
  for (const auto& name : variables_of(first)) {
    if (first.dimensions(name).empty()) continue;
    const auto x = first.values(name), y = second.values(name);
    if (x.size() != y.size()) {
      words += name + ": " + std::to_string(x.size()) + " and " + std::to_string(y.size()) + " values; ";
      continue;
    }
    const auto place =
        std::ranges::mismatch(x, y, [](double p, double q) { return std::memcmp(&p, &q, sizeof p) == 0; });
    if (place.in1 != x.end()) words += name + " from value " + std::to_string(place.in1 - x.begin()) + " on; ";
  }
  auto p = nlohmann::json::parse(contents(a / "summary.json")), q = nlohmann::json::parse(contents(b / "summary.json"));
  for (const char* key : {"status", "exit_code", "simulated_seconds", "records", "final"})
    if (p[key] != q[key]) words += std::string(key) + " of the summary; ";
  for (const auto& [name, value] : p["statistics"].items())
    if (!is_cpu_time(name) && value != q["statistics"][name]) words += name + " of the summary's statistics; ";
  return words;
}

}  // namespace talus::support
