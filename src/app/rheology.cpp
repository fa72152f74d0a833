#include "app/rheology.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/material.hpp"
#include "app/number_list.hpp"
#include "app/rheology_points.hpp"
#include "app/rheology_report.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> numbers(const std::string& text, const char* option, const char* unit) {
  if (text.empty()) return {};
  auto list = number_list(text, option, unit);
  for (const double each : list)
    if (each < 0.0)
      throw core::ConfigError(std::string(option) + ": expected numbers of at least 0 [" + unit + "], found " +
                              shortest(each));
  return list;
}

/// The laws asked for: the words behind --law, or the empty word for that of the file.
std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : list + ",") {
    if (c != ',') word += c;
    else words.push_back(std::exchange(word, ""));
  }
  return words;
}

RheologyPoints points_of(const RheologyRequest& request) {
  if (int{!request.I.empty()} + int{!request.mu.empty()} + int{!request.zeta.empty()} > 1)
    throw core::ConfigError("--I, --mu, --zeta: expected one of them");
  RheologyPoints points{.I = numbers(request.I, "--I", "1"),
                        .mu = numbers(request.mu, "--mu", "1"),
                        .zeta = numbers(request.zeta, "--zeta", "degree"),
                        .k = numbers(request.k, "--k", "1/m"),
                        .thickness = request.thickness};
  for (const double each : points.zeta)
    if (!(each > 0.0 && each < 90.0))
      throw core::ConfigError("--zeta: expected angles above 0 and below 90 [degree], found " + shortest(each));
  if (points.thickness && points.zeta.empty()) throw core::ConfigError("--thickness: expected --zeta as well");
  if (points.thickness && !(*points.thickness > 0.0))
    throw core::ConfigError("--thickness: expected a number above 0 [m], found " + shortest(*points.thickness));
  return points;
}

}  // namespace

void rheology_command(const RheologyRequest& request) {
  const RheologyPoints points = points_of(request);
  const bool has_points = points.size() > 0;
  if (request.csv && !has_points)
    throw core::ConfigError("--csv: expected --I, --mu or --zeta as well, whose table it takes");
  Json laws = Json::array();
  std::string text, csv;
  for (const auto& word : words_of(request.laws)) {
    auto overrides = request.overrides;
    if (!word.empty()) overrides.push_back("rheology.law=" + word);
    const auto channel = read_material(request.file, overrides);
    std::vector<std::string> notes;
    Table table = rheology_table(channel, points, notes);
    Json entry{{"law", law_word(channel.law)}};
    entry.update(rheology_summary(channel.law));
    if (has_points) entry["points"] = json_of(table);
    if (!notes.empty()) entry["notes"] = notes;
    laws.push_back(std::move(entry));
    text += (text.empty() ? "" : "\n") + rheology_text(channel.law);
    if (has_points) text += "\n" + text_of(table);
    for (const auto& note : notes) text += note + "\n";
    table.insert(table.begin(), {"law", "", "", std::vector<std::string>(points.size(), law_word(channel.law))});
    const std::string rows = csv_of(table);
    csv += csv.empty() ? rows : rows.substr(rows.find('\n') + 1);
  }
  if (request.csv) output::write_atomically(*request.csv, csv);
  const std::string out =
      request.json ? Json{{"file", request.file.string()}, {"laws", std::move(laws)}}.dump(1) + "\n" : text;
  std::fputs(out.c_str(), stdout);
}

void add_rheology(CLI::App& program) {
  auto request = std::make_shared<RheologyRequest>();
  auto* command = program.add_subcommand("rheology", "the friction law: curves, well-posedness, growth of short waves");
  command->add_option("file", request->file, "scene or material file (TOML)")->required()->type_name("FILE.toml");
  command->add_option("--I", request->I, "inertial numbers [1]: 0.01,0.1 or 0:0.4:0.01 or 1e-6:1e3:x46")
      ->type_name("LIST");
  command->add_option("--mu", request->mu, "frictions [1] instead, each turned into its I")->type_name("LIST");
  command->add_option("--zeta", request->zeta, "slopes [degree] instead, each standing for mu = tan zeta")
      ->type_name("LIST");
  command->add_option("--thickness", request->thickness, "with --zeta: Bagnold's flow (B2) of such a layer [m]")
      ->type_name("H");
  command->add_option("--k", request->k, "wave numbers [1/m] for growth rates in units of the shear rate")
      ->type_name("LIST");
  command->add_option("--law", request->laws, "rheology.law instead of that in the file; several with commas")
      ->type_name("LAW");
  command->add_option("--set", request->overrides, "replace a value of the file; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--json", request->json, "print JSON, in full precision");
  command->add_option("--csv", request->csv, "write the table there, too")->type_name("X.csv");
  command->footer(
      "Examples:\n"
      "  talus rheology runs/examples/heap_q46.toml\n"
      "  talus rheology runs/examples/heap_q46.toml --I 1e-6:1e3:x46 --k 100,1000\n"
      "  talus rheology runs/examples/heap_q46.toml --law classical,partially_regularised --I 0:2:0.01 --json\n"
      "  talus rheology runs/examples/heap_no_walls.toml --zeta 24:32:1 --thickness 0.01\n"
      "Appendix A, from deposits h_stop to mu_s, mu_d, I_0: talus hstop --help. Flow between walls: talus steady.");
  command->callback([request] { rheology_command(*request); });
}

}  // namespace talus::app
