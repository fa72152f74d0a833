#pragma once

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "support/program.hpp"

/// Runs of the program on small scenes, for the tests of what happens to runs.
namespace talus::support {

using Words = std::vector<std::string>;

inline const std::string chute_scene = TALUS_SOURCE_DIR "/runs/examples/chute_periodic.toml";
inline const std::string heap_scene = TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml";

/// `words` with a "--set" before each of `settings`, "key=value".
inline Words with_settings(Words words, const Words& settings) {
  for (const auto& setting : settings) words.insert(words.end(), {"--set", setting});
  return words;
}

/// A run of `scene` into `out` with `settings`, where `more` has no other value for the same key, and `more`.
inline Words run_with(const std::string& scene, const std::filesystem::path& out, Words settings, const Words& more) {
  const auto key = [](const std::string& setting) { return setting.substr(0, setting.find('=')); };
  std::erase_if(settings, [&](const std::string& setting) {
    return std::ranges::any_of(more, [&](const std::string& other) { return key(other) == key(setting); });
  });
  return with_settings(with_settings({"run", scene, "--out", out.string()}, settings), more);
}

/// A heap of 30 x 8 cells, poured for 5 s and draining for 5 s: about half a second of computing.
inline Words small_heap(const std::filesystem::path& out, const Words& more = {}) {
  return run_with(heap_scene, out,
                  {"grid.columns=30", "grid.layers=8", "output.times=[3.3]", "time.end=10", "inflow.stop=5",
                   "output.interval=1", "output.series_interval=0.1"},
                  more);
}

/// The periodic chute in steps of 1e-5 s for 100 s: minutes, so that there is time to disturb it.
inline Words long_chute(const std::filesystem::path& out, const Words& more = {}) {
  return run_with(chute_scene, out,
                  {"time.end=100", "integrator.max_step=1e-5", "output.series_interval=1e-4", "output.times=[]"}, more);
}

inline nlohmann::json summary_in(const std::filesystem::path& folder) {
  return nlohmann::json::parse(contents(folder / "summary.json"));
}

inline bool says(const Outcome& outcome, const std::string& words) {
  return outcome.output.find(words) != std::string::npos;
}

/// Waits, for a minute at most, until `condition` holds. False if it never did.
template <class Condition>
bool wait_until(Condition&& condition) {
  const auto begin = std::chrono::steady_clock::now();
  while (!condition()) {
    if (std::chrono::steady_clock::now() - begin > std::chrono::minutes(1)) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Waits until the run in `folder` has said `words` in its log.
inline bool wait_for_log(const std::filesystem::path& folder, const std::string& words) {
  return wait_until([&] { return contents(folder / "run.log").find(words) != std::string::npos; });
}

inline Outcome run_talus(const Words& words) { return outcome_of(TALUS_PROGRAM, words); }

}  // namespace talus::support
