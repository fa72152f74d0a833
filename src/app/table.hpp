#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

namespace talus::app {

/// A column of a command's result: its name ends in its unit where that is not 1, as zeta_deg or h_stop_m. A number
/// that is not finite stands for "none": "-" for people, empty in CSV, null in JSON.
struct Column {
  std::string name, unit, doc;
  std::variant<std::vector<double>, std::vector<std::string>> values;
};

/// Precondition of all of these: columns of one length.
using Table = std::vector<Column>;

/// Aligned, with a line of names, ten significant digits.
[[nodiscard]] std::string text_of(const Table& table);
/// A line of names, then rows that read back as the same numbers.
[[nodiscard]] std::string csv_of(const Table& table);
/// {name: {"unit", "description", "values"}} in the order of the columns.
[[nodiscard]] nlohmann::ordered_json json_of(const Table& table);

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string shortest(double value);

/// null where the number is not finite.
[[nodiscard]] nlohmann::ordered_json json_of(double value);

}  // namespace talus::app
