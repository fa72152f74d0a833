#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"
#include "support/same_data.hpp"

namespace talus::support {

/// What differs, bit by bit, between the results of two runs: variables of run.nc, numbers of summary.json. "" for nothing.
/// CPU times do not count.
inline std::string differences_between(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::string words;
  for (const auto& name : differing_variables(a / "run.nc", b / "run.nc")) words += name + "; ";
  auto p = nlohmann::json::parse(contents(a / "summary.json")), q = nlohmann::json::parse(contents(b / "summary.json"));
  for (const char* key : {"status", "exit_code", "simulated_seconds", "records", "final"})
    if (p[key] != q[key]) words += std::string(key) + " of the summary; ";
  for (const auto& [name, value] : p["statistics"].items())
    if (!name.starts_with("cpu_") && value != q["statistics"][name]) words += name + " of the summary's statistics; ";
  return words;
}

}  // namespace talus::support
