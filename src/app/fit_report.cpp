#include "app/fit_report.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/rheology_report.hpp"
#include "app/versions.hpp"
#include "output/provenance.hpp"
#include "output/table_file.hpp"

namespace talus::app {
namespace {

std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5g", value);
  return std::isfinite(value) ? text.data() : "-";
}

/// With five digits, as nobody reads ten of what is known to three.
Table for_people(Table table) {
  for (auto& column : table) {
    const auto* numbers = std::get_if<std::vector<double>>(&column.values);
    if (!numbers) continue;
    std::vector<std::string> words;
    for (const double value : *numbers) words.push_back(rounded(value));
    column.values = std::move(words);
  }
  return table;
}

bool is_empty(const Table& table) {
  return std::visit([](const auto& values) { return values.empty(); }, table.front().values);
}

std::string count(std::size_t n, const std::string& thing, const std::string& things = "") {
  return std::to_string(n) + " " + (n == 1 ? thing : things.empty() ? thing + "s" : things);
}

/// Sections that only a picture needs, or a reader of the file.
bool is_long(const FitSection& section) {
  return section.name == "likelihood" || section.name == "curve" || section.name == "profile_curve";
}

std::string verdict(const fit::Fit& fit) {
  std::string out = "chi2 " + rounded(fit.chi2) + " with " + std::to_string(fit.freedom) + " degrees of freedom";
  if (fit.freedom > 0) {
    out += ", chance of more " + rounded(fit.chance);
    if (fit.chance < 1e-3) out += ": the model does not fit within the errors stated";
  }
  return out + "\n";
}

/// What the second stage did, but for its numbers.
std::string layer_text(const fit::LayerFindings& layer) {
  std::string out =
      "stage 2: " + count(layer.stage.data.size(), "datum of the layer", "data of the layer") + ", " +
      count(static_cast<std::size_t>(layer.n_runs), "run") + " of its scene, chi2 " + rounded(layer.chi2_before) +
      " where stage 1 ended" +
      (layer.converged ? "\n" : "; NOT CONVERGED: the runs allowed by stage_2.evaluations were used up\n");
  out += "two runs at nearly equal parameters differ by " + rounded(layer.noise) +
         " standard deviations a datum (root mean square); what moves the data by less than three times that counts as "
         "unseen\n";
  if (!layer.failures.empty()) {
    out += count(layer.failures.size(), "run") + " failed, and counted as far from the data:\n";
    for (const auto& failure : layer.failures) out += "  " + failure + "\n";
  }
  std::string names;
  for (const auto& name : layer.seen_by_layer_only) names += (names.empty() ? "" : ", ") + name;
  return out + "fixed by the layer's data, not by the steady flow: " + (names.empty() ? "none" : names) + "\n";
}

}  // namespace

std::string fit_text(const FitFile& file, const steady::Answer<fit::Fit>& answer) {
  const auto& problem = file.problem;
  std::size_t speeds = 0;
  for (const auto& profile : problem.profiles) speeds += profile.depth.size();
  std::string out = (file.title.empty() ? file.name : file.title) + "\n" + law_word(problem.varied.channel.law) +
                    " law, " + count(problem.slopes.size(), "slope") + ", " + count(speeds, "speed") + " in " +
                    count(problem.profiles.size(), "profile") + "\n";
  if (!answer) return out + "\nNo fit: " + answer.reason() + "\n";
  out += verdict(*answer);
  if (answer->layer) out += layer_text(*answer->layer);
  if (answer->infeasible_draws > 0)
    out += count(static_cast<std::size_t>(answer->infeasible_draws), "parameter set") +
           " drawn between the bounds had no steady state at some flow measured\n";
  if (problem.condition != fit::Condition::report)
    out += std::string("kept to ") + (problem.condition == fit::Condition::C ? "C <= 0" : "q <= 1") +
           " at the surface; worst " + (problem.condition == fit::Condition::C ? "C " : "q - 1 ") +
           rounded(answer->worst_condition) +
           (answer->worst_condition > -1e-6 ? ", so that bound decides; errors are those without it\n" : "\n");
  for (const auto& section : fit_sections(file, *answer)) {
    if (is_long(section) || is_empty(section.table)) continue;
    out += "\n" + section.heading + "\n" + text_of(for_people(section.table));
  }
  return out;
}

nlohmann::ordered_json fit_json(const FitFile& file, const steady::Answer<fit::Fit>& answer) {
  nlohmann::ordered_json out{
      {"talus_version", output::version()},
      {"git_revision", output::git_revision()},
      {"name", file.name},
      {"title", file.title},
      {"law", law_word(file.problem.varied.channel.law)},
      {"exists", static_cast<bool>(answer)},
      {"reason", answer ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(answer.reason())}};
  if (!answer) return out;
  out["chi2"] = json_of(answer->chi2);
  out["freedom"] = answer->freedom;
  out["chance_of_more"] = json_of(answer->chance);
  out["infeasible_draws"] = answer->infeasible_draws;
  if (answer->layer) {
    const auto& layer = *answer->layer;
    out["stage_2"] = {{"runs", layer.n_runs},          {"failures", layer.failures},
                      {"converged", layer.converged},  {"chi2_before", json_of(layer.chi2_before)},
                      {"noise", json_of(layer.noise)}, {"seen_by_layer_only", layer.seen_by_layer_only}};
  }
  auto covariance = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < answer->x.size(); ++i) {
    auto row = nlohmann::ordered_json::array();
    for (Eigen::Index j = 0; j < answer->x.size(); ++j) {
      const auto known = [&](Eigen::Index k) {
        return answer->estimates[static_cast<std::size_t>(k)].error.has_value();
      };
      row.push_back(known(i) && known(j) ? json_of(answer->all.covariance(i, j)) : nlohmann::ordered_json(nullptr));
    }
    covariance.push_back(row);
  }
  out["covariance"] = covariance;
  for (const auto& section : fit_sections(file, *answer)) out[section.name] = json_of(section.table);
  return out;
}

void write_fit_file(const std::filesystem::path& path, const FitFile& file, const fit::Fit& fit,
                    const std::string& command) {
  output::Table table;
  table.attributes =
      output::provenance_attributes({.scene_text = "", .command = command, .libraries = library_versions()});
  table.attributes["Conventions"] = "CF-1.8";
  table.attributes["title"] = file.title.empty() ? file.name : file.title;
  table.attributes["law"] = law_word(file.problem.varied.channel.law);
  table.attributes["chi2"] = fit.chi2;
  table.attributes["degrees_of_freedom"] = fit.freedom;
  table.attributes["chance_of_more"] = fit.chance;
  if (fit.layer) {
    table.attributes["stage_2_runs"] = fit.layer->n_runs;
    table.attributes["stage_2_failed_runs"] = static_cast<int>(fit.layer->failures.size());
    table.attributes["stage_2_converged"] = fit.layer->converged ? "yes" : "no";
    table.attributes["stage_2_noise"] = fit.layer->noise;
  }
  for (const auto& section : fit_sections(file, fit)) {
    if (is_empty(section.table)) continue;
    const auto rows = std::visit([](const auto& values) { return values.size(); }, section.table.front().values);
    table.dimensions.emplace_back(section.name, rows);
    for (const auto& column : section.table) {
      output::TableVariable variable{section.name + "_" + column.name, {section.name}, column.unit, column.doc, {}};
      std::visit([&](const auto& values) { variable.values = values; }, column.values);
      table.variables.push_back(std::move(variable));
    }
  }
  output::write_table(path, table);
}

}  // namespace talus::app
