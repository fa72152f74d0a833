#include "app/growth_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>

#include "app/refinement.hpp"
#include "app/table.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using study::GrowthTendency;

std::string grid_of(const GrowthMember& member, int finer = 0) {
  const int times = static_cast<int>(std::pow(refinement_ratio, finer));
  return fmt::format("{}x{}", times * member.columns, times * member.layers);
}

std::string words_of(const study::GrowthVerdict& verdict, const GrowthMember& finest) {
  std::string out(word_of(verdict.tendency));
  if (verdict.tendency == GrowthTendency::blows_up) out += fmt::format(" with a rate as k^{:.2f}", verdict.exponent);
  if (verdict.tendency == GrowthTendency::cannot_tell)
    out += fmt::format(" from these grids, {} cells may", grid_of(finest, verdict.finer));
  return out;
}

std::string words_of(const GrowthRun& run) {
  const double length = 1e3;  // mm
  const std::string rate = std::isfinite(run.fit.rate)
                               ? fmt::format("{:.4g} +- {:.2g} 1/s", run.fit.rate, run.fit.uncertainty)
                               : "no rate, for want of time";
  std::string out = fmt::format("{}: {} (its modes {:.4g})", grid_of(run.member), rate, run.member.predicted);
  if (!run.end.empty())
    out += fmt::format(", broke down at t = {:.3g} s, strongest {} waves in the box, at x = {:.3g} mm, z = {:.3g} mm",
                       run.reached, run.wave, length * run.x, length * run.z);
  else if (std::isfinite(run.taken_over))
    out += fmt::format(", until others take over at t = {:.3g} s, at the end those of {} in the box", run.taken_over,
                       run.wave);
  return out;
}

std::string hidden_words(const HiddenGrowth& hidden) {
  const std::string grid = hidden.cells > 0 ? fmt::format("from {} cells over the thickness on", hidden.cells)
                                            : fmt::format("on no grid of up to {} cells", hidden.most_cells);
  return fmt::format("by linear theory short waves grow in {:.3g} % of the layer's thickness, by the symbol {}",
                     100.0 * hidden.share, grid);
}

Json json_of_run(const GrowthRun& run) {
  return {{"columns", run.member.columns},
          {"layers", run.member.layers},
          {"first_wave", run.member.disturbance.first_wave},
          {"last_wave", run.member.disturbance.last_wave},
          {"profiles", run.member.disturbance.profiles},
          {"amplitude_m_s", run.member.disturbance.speed},
          {"rate_1_s", json_of(run.fit.rate)},
          {"uncertainty_1_s", json_of(run.fit.uncertainty)},
          {"window_s", {run.fit.from, run.fit.to}},
          {"points", run.fit.n},
          {"rate_of_modes_1_s", json_of(run.member.predicted)},
          {"taken_over_s", json_of(run.taken_over)},
          {"reached_s", run.reached},
          {"broke_down", run.end.empty() ? Json(nullptr) : Json(run.end)},
          {"strongest_wave_at_end", run.wave},
          {"largest_at_end_m", {{"x", json_of(run.x)}, {"z", json_of(run.z)}}}};
}

Json json_of_verdict(const study::GrowthVerdict& verdict, const GrowthMember& finest) {
  Json out{{"verdict", word_of(verdict.tendency)}, {"rate_exponent", json_of(verdict.exponent)}};
  out["grid_that_may_tell"] = verdict.finer > 0 ? Json(grid_of(finest, verdict.finer)) : Json(nullptr);
  return out;
}

/// What each run has one of.
template <class Value, class Get>
void add_grid_values(output::Table& table, const GrowthStudy& study, const char* name, const char* unit,
                     const char* words, const Get& get) {
  std::vector<Value> values;
  for (const auto& row : study.rows)
    for (const auto& run : row.runs) values.push_back(get(run));
  table.variables.push_back({name, {"growth_disturbance", "growth_grid"}, unit, words, values});
}

void add_courses(output::Table& table, const GrowthStudy& study) {
  std::size_t most = 0;
  for (const auto& row : study.rows)
    for (const auto& run : row.runs) most = std::max(most, run.times.size());
  if (most == 0) return;
  table.dimensions.emplace_back("growth_point", most);
  const auto add = [&](const char* name, const char* unit, const char* words, std::vector<double> GrowthRun::*part) {
    std::vector<double> values;
    for (const auto& row : study.rows)
      for (const auto& run : row.runs) {
        values.insert(values.end(), (run.*part).begin(), (run.*part).end());
        values.insert(values.end(), most - (run.*part).size(), std::numeric_limits<double>::quiet_NaN());
      }
    table.variables.push_back({name, {"growth_disturbance", "growth_grid", "growth_point"}, unit, words, values});
  };
  add("growth_time", "s", "simulated time", &GrowthRun::times);
  add("growth_amplitude", "m s-1", "root mean square of u in the disturbed waves", &GrowthRun::amplitudes);
  add("growth_others", "m s-1", "root mean square of u in all other waves", &GrowthRun::others);
}

}  // namespace

std::string grid_that_may_tell(const GrowthStudy& study) {
  return study.verdict.finer > 0 ? grid_of(study.rows.front().runs.back().member, study.verdict.finer) : "";
}

std::string sentence_of(const GrowthStudy& study) {
  std::string out =
      "Disturbances of the uniform layer in time: " + words_of(study.verdict, study.rows.front().runs.back().member);
  if (study.hidden) out += "; " + hidden_words(*study.hidden);
  out += ".";
  for (const auto& row : study.rows) {
    out += "\n" + row.name + ": " + words_of(row.verdict, row.runs.back().member);
    for (const auto& run : row.runs) out += "; " + words_of(run);
    out += ".";
  }
  return out;
}

Json json_of(const GrowthStudy& study) {
  const auto& finest = study.rows.front().runs.back().member;
  Json rows = Json::array();
  for (const auto& row : study.rows) {
    Json entry{{"disturbance", row.name}};
    entry.update(json_of_verdict(row.verdict, finest));
    entry["runs"] = Json::array();
    for (const auto& run : row.runs) entry["runs"].push_back(json_of_run(run));
    rows.push_back(std::move(entry));
  }
  Json all{{"words", sentence_of(study)}};
  all.update(json_of_verdict(study.verdict, finest));
  all["seed"] = finest.disturbance.seed;
  all["ill_posed_in_theory"] =
      study.hidden ? Json{{"share_of_thickness", study.hidden->share},
                          {"seen_from_cells", study.hidden->cells > 0 ? Json(study.hidden->cells) : Json(nullptr)}}
                   : Json(nullptr);
  all["disturbances"] = std::move(rows);
  return all;
}

void add_to(output::Table& table, const GrowthStudy& study) {
  table.dimensions.emplace_back("growth_disturbance", study.rows.size());
  table.dimensions.emplace_back("growth_grid", study.rows.front().runs.size());
  std::vector<std::string> names;
  std::vector<std::int64_t> verdicts;
  std::vector<double> exponents;
  for (const auto& row : study.rows) {
    names.push_back(row.name);
    verdicts.push_back(static_cast<std::int64_t>(row.verdict.tendency));
    exponents.push_back(row.verdict.exponent);
  }
  const std::vector<std::string> along{"growth_disturbance"};
  table.variables.push_back({"growth_name", along, "", "what was disturbed", names});
  output::TableVariable verdict{"growth_verdict", along, "", "what these grids say", verdicts};
  for (const auto each : study::growth_tendencies()) {
    std::string flag(word_of(each));
    std::ranges::replace(flag, ' ', '_');
    verdict.flags.push_back(flag);
  }
  table.variables.push_back(std::move(verdict));
  table.variables.push_back({"growth_exponent", along, "1", "n of a rate that grows as k^n", exponents});
  using Run = GrowthRun;
  add_grid_values<std::int64_t>(table, study, "growth_columns", "1", "columns of the grid",
                                [](const Run& run) { return run.member.columns; });
  add_grid_values<std::int64_t>(table, study, "growth_layers", "1", "layers of the grid",
                                [](const Run& run) { return run.member.layers; });
  add_grid_values<std::int64_t>(table, study, "growth_strongest_wave", "1",
                                "strongest wave at the end, in whole waves over the box",
                                [](const Run& run) { return run.wave; });
  const auto number = [&](const char* name, const char* unit, const char* words, auto get) {
    add_grid_values<double>(table, study, name, unit, words, get);
  };
  number("growth_rate", "s-1", "fitted growth rate", [](const Run& run) { return run.fit.rate; });
  number("growth_uncertainty", "s-1", "its uncertainty", [](const Run& run) { return run.fit.uncertainty; });
  number("growth_from", "s", "begin of the fitted window", [](const Run& run) { return run.fit.from; });
  number("growth_to", "s", "its end", [](const Run& run) { return run.fit.to; });
  number("growth_predicted", "s-1", "fastest growth rate of the disturbed waves, from the modes",
         [](const Run& run) { return run.member.predicted; });
  number("growth_reached", "s", "simulated time that was reached", [](const Run& run) { return run.reached; });
  number("growth_x", "m", "where u departed most from its mean along x at the end",
         [](const Run& run) { return run.x; });
  number("growth_z", "m", "and at which height", [](const Run& run) { return run.z; });
  add_courses(table, study);
}

}  // namespace talus::app
