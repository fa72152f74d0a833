#include "app/study_wellposed.hpp"

#include <bit>
#include <cstdio>

#include "app/growth_report.hpp"
#include "app/number_list.hpp"
#include "app/plot.hpp"
#include "app/steady_modes.hpp"
#include "app/symbol_study.hpp"
#include "app/theory.hpp"
#include "app/wave_study.hpp"
#include "app/wellposed_verdict.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

struct Result {
  output::Table table;
  Json json;
  std::string words;
  std::optional<WellposedVerdict> verdict;  ///< of the last part that has one

  void add(const std::string& sentence) { words += (words.empty() ? "" : "\n") + sentence; }
};

std::vector<int> sizes_up_to(int most) {
  constexpr int fewest = 16;
  if (most < fewest || !std::has_single_bit(static_cast<unsigned>(most)))
    throw core::ConfigError("study wellposed --cells: expected a power of 2, at least " + std::to_string(fewest) +
                            ", found " + std::to_string(most));
  std::vector<int> sizes;
  for (int n = fewest; n <= most; n *= 2) sizes.push_back(n);
  return sizes;
}

std::vector<double> inertial_numbers(const std::string& list) {
  const auto numbers = number_list(list, "--I", "1");
  for (const double I : numbers)
    if (!(I > 0.0))
      throw core::ConfigError("study wellposed --I: expected inertial numbers above 0, found " + std::to_string(I));
  return numbers;
}

void symbol_part(const WellposedRequest& request, const Scene& scene, Result& result) {
  const auto study = symbol_study(scene, inertial_numbers(request.I), sizes_up_to(request.most_cells), request.jobs);
  add_to(result.table, study);
  result.json["symbol"] = json_of(study);
  const auto theory = theory_of(scene);
  result.verdict =
      verdict_of(study, theory.steady ? std::optional(theory.steady->flow.inertial_number(0.0)) : std::nullopt);
  result.add(sentence_of(study));
}

void wave_part(const WellposedRequest& request, const Scene& scene, Result& result) {
  const auto study = wave_study(scene, request.waves);
  const auto threshold = roll_waves(scene);
  add_to(result.table, study);
  result.json["modes"] = json_of(study, threshold);
  result.add(sentence_of(study, threshold));
}

/// Waves that are asked for; else the longest, and the shortest that the coarsest grid resolves.
std::vector<int> single_waves(const WellposedRequest& request, const Scene& scene) {
  if (!request.single.empty()) return request.single;
  const int shortest = std::max(1, scene.cells.columns / 4);
  return shortest > 1 ? std::vector<int>{1, shortest} : std::vector<int>{1};
}

/// False where a signal ended it.
bool time_part(const WellposedRequest& request, const Scene& scene, const std::filesystem::path& folder,
               Result& result) {
  const auto study = growth_study({request.scene_file, request.overrides, scene, folder / "time", request.levels,
                                   single_waves(request, scene), request.jobs, request.force});
  if (!study) return false;
  add_to(result.table, *study);
  result.json["time"] = json_of(*study);
  result.verdict = verdict_of(*study);
  result.add(sentence_of(*study));
  return true;
}

/// False where a signal ended it.
bool steady_part(const WellposedRequest& request, const Scene& scene, const std::filesystem::path& folder,
                 Result& result) {
  const auto study = steady_modes({request.scene_file, request.overrides, scene, folder, request.jobs, request.force});
  if (!study) return false;
  add_to(result.table, *study);
  result.json["modes"] = json_of(*study);
  result.add(sentence_of(*study));
  return true;
}

int interrupted(const Scene& scene) {
  std::printf("%s: the same command goes on\n", scene.name.c_str());
  return static_cast<int>(core::ExitCode::restartable);
}

}  // namespace

int study_wellposed(const WellposedRequest& request) {
  const Scene scene = read_scene(request.scene_file, request.overrides);
  const auto wanted = [&](const std::string& part) {
    return (request.parts.empty() && part != "time") || std::ranges::find(request.parts, part) != request.parts.end();
  };
  const auto folder = request.out.value_or(std::filesystem::path("out") / (scene.name + "_wellposed"));
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw core::OutputError(core::ExitCode::io_setup,
                            "output folder " + folder.string() + ": cannot be created: " + error.message());
  Result result;
  if (wanted("symbol")) symbol_part(request, scene, result);
  if (wanted("modes")) {
    if (scene.box.periodic) wave_part(request, scene, result);
    else if (!steady_part(request, scene, folder, result)) return interrupted(scene);
  }
  if (wanted("time") && !time_part(request, scene, folder, result)) return interrupted(scene);
  result.table.attributes = output::provenance_attributes({scene.effective, request.command, {}});
  result.table.attributes["Conventions"] = "CF-1.8";
  result.table.attributes["study"] = "wellposed";
  result.table.attributes["title"] = scene.title.empty() ? scene.name : scene.title;
  if (result.verdict) result.words = sentence_of(*result.verdict) + "\n" + result.words;
  result.table.attributes["verdict"] = result.words;
  write_table(folder / "study.nc", result.table);
  Json all{{"study", "wellposed"}, {"scene", scene.name}, {"words", result.words}};
  if (result.verdict) all.update(json_of(*result.verdict));
  all.update(result.json);
  output::write_atomically(folder / "verdict.json", all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  std::printf("%s\n", result.words.c_str());
  std::fflush(stdout);
  draw_study(folder);
  return 0;
}

}  // namespace talus::app
