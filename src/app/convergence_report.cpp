#include "app/convergence_report.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/table.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using study::Tendency;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string digits(double value, const char* format) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// "1.98 2.01"; "-" where differences change their sign.
std::string words_of(const std::vector<double>& orders) {
  std::string out;
  for (const double order : orders) out += (out.empty() ? "" : " ") + digits(order, "%.2f");
  return out.empty() ? "-" : out;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : name + " [" + unit + "]";
}

std::string number_table(const ConvergenceStudy& study) {
  std::vector<std::string> name, finest, orders, value, uncertainty, tendency;
  for (const auto& number : study.numbers) {
    name.push_back(with_unit(number.name, number.unit));
    finest.push_back(digits(number.values[study.first + study.n_counted - 1], "%.8g"));
    orders.push_back(words_of(number.limit.orders));
    value.push_back(digits(number.limit.value, "%.8g"));
    uncertainty.push_back(digits(number.limit.uncertainty, "%.2g"));
    tendency.emplace_back(word_of(number.limit.tendency));
  }
  return text_of(Table{{"number at the end, or @ seconds", "", "", name},
                       {"finest", "", "", finest},
                       {"orders", "", "", orders},
                       {"extrapolated", "", "", value},
                       {"+-", "", "", uncertainty},
                       {"tendency", "", "", tendency}});
}

std::string field_table(const ConvergenceStudy& study) {
  std::vector<std::string> name, differences, orders, error, uncertainty, tendency;
  for (const auto& field : study.fields) {
    name.push_back(with_unit(field.name, field.unit));
    std::string row;
    for (const auto& norms : field.differences) row += (row.empty() ? "" : " ") + digits(norms.L2, "%.2g");
    differences.push_back(row);
    orders.push_back(words_of(field.limit.orders));
    error.push_back(digits(field.limit.error, "%.2g"));
    uncertainty.push_back(digits(field.limit.uncertainty, "%.2g"));
    tendency.emplace_back(word_of(field.limit.tendency));
  }
  return text_of(Table{{"field at the end", "", "", name},
                       {"L2 of differences", "", "", differences},
                       {"orders", "", "", orders},
                       {"error", "", "", error},
                       {"+-", "", "", uncertainty},
                       {"tendency", "", "", tendency}});
}

std::string names_with(const ConvergenceStudy& study, Tendency tendency) {
  std::string out;
  const auto add = [&](const std::string& name, const study::Convergence& limit) {
    if (limit.tendency != tendency) return;
    out += (out.empty() ? "" : ", ") + name;
    if (!limit.orders.empty() && std::isfinite(limit.orders.back()))
      out += " (order " + digits(limit.orders.back(), "%.2f") + ")";
  };
  for (const auto& number : study.numbers) add(number.name, number.limit);
  for (const auto& field : study.fields) add("field " + field.name, field.limit);
  return out;
}

Json json_of_limit(const study::Convergence& limit) {
  Json orders = Json::array();
  for (const double order : limit.orders) orders.push_back(json_of(order));
  return {{"tendency", word_of(limit.tendency)},
          {"orders", std::move(orders)},
          {"extrapolated", json_of(limit.value)},
          {"error_of_finest", json_of(limit.error)},
          {"uncertainty", json_of(limit.uncertainty)}};
}

/// `rows` of `width` each, NaN in front where a row is shorter.
std::vector<double> right_aligned(const std::vector<std::vector<double>>& rows, std::size_t width) {
  std::vector<double> out;
  for (const auto& row : rows) {
    out.insert(out.end(), width - row.size(), none);
    out.insert(out.end(), row.begin(), row.end());
  }
  return out;
}

template <class Item>
void add_limits(output::Table& table, const std::vector<Item>& items, const std::string& dimension,
                std::size_t n_orders, const std::string& order_dimension) {
  std::vector<std::string> names, units, long_names;
  std::vector<std::vector<double>> orders;
  std::vector<double> value, error, uncertainty;
  std::vector<std::int64_t> tendency;
  for (const auto& item : items) {
    names.push_back(item.name);
    units.push_back(item.unit);
    long_names.push_back(item.long_name);
    orders.push_back(item.limit.orders);
    value.push_back(item.limit.value);
    error.push_back(item.limit.error);
    uncertainty.push_back(item.limit.uncertainty);
    tendency.push_back(static_cast<std::int64_t>(item.limit.tendency));
  }
  const auto add = [&](const std::string& what, const std::string& words, auto values) {
    table.variables.push_back({dimension + "_" + what, {dimension}, "", words, std::move(values)});
  };
  add("name", "name; of a record with @ and its time [s]", names);
  add("unit", "unit of its values", units);
  add("long_name", "what it is", long_names);
  add("extrapolated", "best estimate of the limit, in the unit of that row", value);
  add("error", "estimated error on the finest level that counts", error);
  add("uncertainty", "half width of where the limit is expected about the finest value (GCI)", uncertainty);
  add("tendency", "what its values on refined grids say", tendency);
  for (const auto each : study::tendencies()) table.variables.back().flags.emplace_back(word_of(each));
  if (n_orders > 0)
    table.variables.push_back(
        {dimension + "_order",
         {dimension, order_dimension},
         "1",
         "observed order of each three neighbouring levels; none where differences change their sign",
         right_aligned(orders, n_orders)});
}

}  // namespace

std::string text_of(const ConvergenceStudy& study) {
  std::string out;
  for (std::size_t i = 0; i < study.levels.size(); ++i) {
    const auto& level = study.levels[i];
    const auto cpu = level.costs.find("cpu_seconds");
    out += "level " + std::to_string(i) + ": " + level.words + "; " + std::string(word_of(level.state.status));
    if (cpu != level.costs.end()) out += ", " + digits(cpu->second, "%.3g") + " s of CPU";
    out += "\n";
  }
  out += "\n";
  if (!study.numbers.empty()) out += number_table(study) + "\n";
  if (!study.fields.empty()) out += field_table(study) + "\n";
  if (!study.without_value.empty()) {
    out += "without a value:";
    for (const auto& name : study.without_value) out += " " + name;
    out += "\n";
  }
  if (!study.same_as_end.empty()) {
    out += "steady as at the end, and not told again: t =";
    for (const double t : study.same_as_end) out += " " + digits(t, "%g");
    out += " s\n";
  }
  return out + sentence_of(study) + "\n";
}

std::string sentence_of(const ConvergenceStudy& study) {
  const auto verdict = verdict_of(study);
  const std::string counted = std::to_string(study.n_counted) + " levels";
  const std::string finer =
      "; a finer level, --levels " + std::to_string(study.levels.size() + 1) + ", would tell more";
  const auto list = [&](const char* before, Tendency tendency) {
    const std::string names = names_with(study, tendency);
    return names.empty() ? "" : std::string(before) + names;
  };
  switch (verdict) {
    case ConvergenceVerdict::cannot_tell:
      return "Cannot tell: an order needs three neighbouring levels that finished, there are " +
             std::to_string(study.n_counted) + ".";
    case ConvergenceVerdict::convergent:
      return "Convergent: on " + counted + " every number and field is settled or falls at an order of at least " +
             digits(study::least_order, "%g") + ".";
    case ConvergenceVerdict::partly:
      return "Partly convergent on " + counted + list(": slow: ", Tendency::slow) +
             list("; oscillating: ", Tendency::oscillating) + list("; unknown: ", Tendency::unknown) + finer + ".";
    case ConvergenceVerdict::not_convergent: break;
  }
  return "Not convergent on " + counted + list(": differences do not fall: ", Tendency::divergent) +
         list("; slow: ", Tendency::slow) + list("; oscillating: ", Tendency::oscillating) +
         list("; unknown: ", Tendency::unknown) + finer + ".";
}

std::string json_text_of(const ConvergenceStudy& study) {
  Json levels = Json::array(), numbers = Json::object(), fields = Json::object();
  for (std::size_t i = 0; i < study.levels.size(); ++i) {
    const auto& level = study.levels[i];
    const bool counts = i >= study.first && i < study.first + study.n_counted;
    levels.push_back({{"settings", level.words},
                      {"status", word_of(level.state.status)},
                      {"counts", counts},
                      {"reason", level.state.reason.empty() ? Json(nullptr) : Json(level.state.reason)}});
  }
  for (const auto& number : study.numbers) {
    Json values = Json::array();
    for (const double v : number.values) values.push_back(json_of(v));
    Json entry{{"unit", number.unit}, {"long_name", number.long_name}, {"values", std::move(values)}};
    entry.update(json_of_limit(number.limit));
    numbers[number.name] = std::move(entry);
  }
  for (const auto& field : study.fields) {
    Json norms{{"L1", Json::array()}, {"L2", Json::array()}, {"Linf", Json::array()}};
    for (const auto& each : field.differences) {
      norms["L1"].push_back(json_of(each.L1));
      norms["L2"].push_back(json_of(each.L2));
      norms["Linf"].push_back(json_of(each.Linf));
    }
    Json entry{{"unit", field.unit}, {"long_name", field.long_name}, {"differences", std::move(norms)}};
    auto limit = json_of_limit(field.limit);
    limit.erase("extrapolated");
    entry.update(limit);
    fields[field.name] = std::move(entry);
  }
  const Json all{{"study", "converge"},
                 {"verdict", word_of(verdict_of(study))},
                 {"words", sentence_of(study)},
                 {"levels", std::move(levels)},
                 {"numbers", std::move(numbers)},
                 {"fields", std::move(fields)},
                 {"without_value", study.without_value},
                 {"steady_as_at_the_end_s", study.same_as_end}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void add_to(output::Table& table, const ConvergenceStudy& study) {
  const std::size_t n_steps = study.n_counted > 0 ? study.n_counted - 1 : 0;
  const std::size_t n_triples = n_steps > 0 ? n_steps - 1 : 0;
  if (n_steps > 0) table.dimensions.emplace_back("step", n_steps);
  if (n_triples > 0) table.dimensions.emplace_back("triple", n_triples);
  if (!study.numbers.empty()) {
    table.dimensions.emplace_back("number", study.numbers.size());
    add_limits(table, study.numbers, "number", n_triples, "triple");
    std::vector<double> values;
    for (const auto& number : study.numbers) values.insert(values.end(), number.values.begin(), number.values.end());
    table.variables.push_back({"number_value", {"number", "level"}, "", "value on each level", values});
  }
  if (study.fields.empty()) return;
  table.dimensions.emplace_back("field", study.fields.size());
  add_limits(table, study.fields, "field", n_triples, "triple");
  const auto norm = [&](const char* name, double study::DifferenceNorms::*which) {
    std::vector<double> values;
    for (const auto& field : study.fields)
      for (const auto& each : field.differences) values.push_back(each.*which);
    table.variables.push_back({std::string("field_difference_") + name,
                               {"field", "step"},
                               "",
                               std::string(name) + " norm of the difference between neighbouring levels that count",
                               values});
  };
  norm("L1", &study::DifferenceNorms::L1);
  norm("L2", &study::DifferenceNorms::L2);
  norm("Linf", &study::DifferenceNorms::Linf);
}

}  // namespace talus::app
