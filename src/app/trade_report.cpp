#include "app/trade_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/table.hpp"
#include "output/csv.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using study::Priced;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double megabyte = 1e6;
constexpr std::array relative_errors{0.1, 0.03, 0.01, 3e-3, 1e-3};
constexpr std::array degrees{3.0, 1.0, 0.5, 0.2};

template <class... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  std::array<char, 300> text{};
  std::snprintf(text.data(), text.size(), pattern, numbers...);
  return text.data();
}

std::string digits(double value, const char* pattern) { return std::isfinite(value) ? format(pattern, value) : "-"; }

double cost(const TradeRow& row, const char* name) {
  const auto found = row.costs.find(name);
  return found == row.costs.end() ? none : found->second;
}

double error(const TradeRow& row, const std::string& number) {
  const auto found = row.errors.find(number);
  return found == row.errors.end() ? none : found->second;
}

std::string name_of(const TradeChoice& choice) { return choice.group + " " + choice.words; }

std::string with_unit(const TradeNumber& number) {
  return number.unit.empty() || number.unit == "1" ? number.name : number.name + " [" + number.unit + "]";
}

bool contains(const std::vector<std::size_t>& list, std::size_t i) { return std::ranges::find(list, i) != list.end(); }

std::string reason_of(const TradeRow& row) { return row.state.reason.substr(0, row.state.reason.find('\n')); }

/// "cheapest within 1 %: grid 75x8 (2.1 s of CPU, off by 0.6 %)".
std::string line(const TradeStudy& study, const std::vector<Priced>& priced, double within, const std::string& what,
                 const char* unit, double factor) {
  const std::string target = "For " + format("%g %s", within * factor, unit) + " in " + what + ": ";
  const auto best = study::cheapest_within(priced, within);
  if (!best) return target + "none of these.\n";
  return target + name_of(study.rows[*best].choice) + ", " + format("%.3g s of CPU", priced[*best].cost) + ", off by " +
         format("%.2g %s", priced[*best].error * factor, unit) + ".\n";
}

std::string rows_text(const TradeStudy& study) {
  const auto front = study::pareto_front(study.priced());
  std::vector<std::string> name, cpu, memory, steps, failures, factorisations, absolute, relative, exact, mark;
  const auto priced = study.priced();
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const auto& row = study.rows[i];
    name.push_back(name_of(row.choice));
    cpu.push_back(digits(row.cost(), "%.3g"));
    memory.push_back(digits(cost(row, "peak_memory_bytes") / megabyte, "%.0f"));
    steps.push_back(digits(cost(row, "n_steps"), "%.0f"));
    failures.push_back(digits(cost(row, "n_newton_failures") + cost(row, "n_error_test_failures"), "%.0f"));
    factorisations.push_back(digits(cost(row, "n_factorisations"), "%.0f"));
    absolute.push_back(digits(error(row, study.judge), "%.2g"));
    relative.push_back(digits(100.0 * priced[i].error, "%.2g"));
    exact.push_back(digits(row.exact_error.value_or(none), "%.2f"));
    mark.emplace_back(row.state.status != sweep::Status::finished ? word_of(row.state.status)
                                                                  : (contains(front, i) ? "front" : ""));
  }
  Table table{{"choice", "", "", name},     {"CPU s", "", "", cpu},         {"MB", "", "", memory},
              {"steps", "", "", steps},     {"failures", "", "", failures}, {"LUs", "", "", factorisations},
              {"off by", "", "", absolute}, {"%", "", "", relative}};
  if (study.exact) table.push_back({"off the exact [deg]", "", "", exact});
  table.push_back({"", "", "", mark});
  return text_of(table);
}

Json front_json(const TradeStudy& study, const std::vector<Priced>& priced) {
  Json out = Json::array();
  for (const std::size_t i : study::pareto_front(priced))
    out.push_back({{"choice", name_of(study.rows[i].choice)},
                   {"cpu_seconds", json_of(priced[i].cost)},
                   {"error", json_of(priced[i].error)}});
  return out;
}

}  // namespace

std::string advice_of(const TradeStudy& study) {
  std::string out;
  const auto priced = study.priced();
  for (const double within : relative_errors) out += line(study, priced, within, study.judge, "%", 100.0);
  if (study.exact) {
    const auto by_slope = study.priced_by_slope();
    for (const double within : degrees)
      out += line(study, by_slope, within, "the slope against the exact one", "degrees", 1.0);
  }
  return out;
}

std::string text_of(const TradeStudy& study) {
  const auto& judged = study.judged();
  std::string out = rows_text(study) + "\nErrors are those of " + with_unit(judged) +
                    ", the largest over the recorded times, against the reference; % of " +
                    format("%.4g", judged.scale) + ".\n";
  out += std::isfinite(judged.uncertainty)
             ? "The reference itself is known to " + format("%.2g %%", 100.0 * judged.uncertainty / judged.scale) +
                   " (grid convergence index): errors below that say nothing.\n"
             : "How well the reference is known cannot be told from these grids.\n";
  if (study.exact)
    out += "Exact slope at t = " + format("%g s: %.3f degrees, of grains without u_c and other regularisations.\n",
                                          study.exact->time, study.exact->degrees);
  if (study.growth) out += "CPU grows as cells to the power " + format("%.2f", *study.growth) + ".\n";
  for (const auto& row : study.rows)
    if (row.state.status == sweep::Status::failed)
      out += "Failed: " + name_of(row.choice) + ": " + reason_of(row) + "\n";
  for (const auto& why : study.left_out) out += "Left out: " + why + "\n";
  return out + "\n" + advice_of(study);
}

std::string csv_of(const TradeStudy& study) {
  std::vector<std::string> names;
  for (const auto& row : study.rows)
    for (const auto& [name, value] : row.costs)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  std::ranges::sort(names);
  std::vector<std::string> fields{"group", "choice", "status", "reason"};
  fields.insert(fields.end(), names.begin(), names.end());
  for (const auto& number : study.numbers) fields.push_back("error_" + with_unit(number));
  if (study.exact) fields.emplace_back("error_against_exact_slope [degree]");
  std::string out = output::csv_line(fields);
  const auto number = [&](double v) { fields.push_back(std::isfinite(v) ? shortest(v) : ""); };
  for (const auto& row : study.rows) {
    fields = {row.choice.group, row.choice.words, std::string(word_of(row.state.status)), reason_of(row)};
    for (const auto& name : names) number(cost(row, name.c_str()));
    for (const auto& each : study.numbers) number(error(row, each.name));
    if (study.exact) number(row.exact_error.value_or(none));
    out += output::csv_line(fields);
  }
  return out;
}

std::string json_text_of(const TradeStudy& study) {
  Json failed = Json::array();
  for (const auto& row : study.rows) {
    if (row.state.status == sweep::Status::finished) continue;
    failed.push_back(
        {{"choice", name_of(row.choice)}, {"status", word_of(row.state.status)}, {"reason", row.state.reason}});
  }
  Json all{{"study", "trade"},
           {"judge", study.judge},
           {"reference_uncertainty", json_of(study.judged().uncertainty / study.judged().scale)},
           {"front", front_json(study, study.priced())},
           {"words", advice_of(study)},
           {"cpu_growth_exponent", study.growth ? json_of(*study.growth) : Json(nullptr)},
           {"not_finished", std::move(failed)},
           {"left_out", study.left_out}};
  if (study.exact) {
    all["exact_slope"] = {{"time", study.exact->time}, {"degrees", study.exact->degrees}};
    all["front_by_exact_slope"] = front_json(study, study.priced_by_slope());
  }
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void add_to(output::Table& table, const TradeStudy& study) {
  std::vector<std::string> groups, words, reasons;
  std::vector<std::int64_t> on_front(study.rows.size(), 0);
  std::vector<double> exact;
  for (const auto& row : study.rows) {
    groups.push_back(row.choice.group);
    words.push_back(row.choice.words);
    reasons.push_back(reason_of(row));
    exact.push_back(row.exact_error.value_or(none));
  }
  for (const std::size_t i : study::pareto_front(study.priced())) on_front[i] = 1;
  const std::vector<std::string> along{"choice"};
  table.variables.push_back({"group", along, "", "what is varied", groups});
  table.variables.push_back({"choice_words", along, "", "to what", words});
  table.variables.push_back({"reason", along, "", "why it did not finish", reasons});
  table.variables.push_back(
      {"on_front", along, "", "1 where no other choice is cheaper and more accurate at once", on_front});
  if (study.exact)
    table.variables.push_back(
        {"exact_slope_error", along, "degree",
         "slope of the steady heap against the exact one, at " + format("%g s", study.exact->time), exact});
  for (const auto& number : study.numbers) {
    std::vector<double> errors;
    for (const auto& row : study.rows) errors.push_back(error(row, number.name));
    table.variables.push_back({"error_" + number.name,
                               along,
                               number.unit,
                               "largest difference over the recorded times from the reference: " + number.long_name,
                               errors,
                               {{"reference_scale", number.scale}, {"reference_uncertainty", number.uncertainty}}});
  }
  table.attributes["judge"] = study.judge;
}

}  // namespace talus::app
