#include "app/table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>

#include "output/csv.hpp"

namespace talus::app {
namespace {

using Cells = std::vector<std::string>;

std::string ten_digits(double value) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 10).ptr;
  return {buffer.data(), end};
}

Cells cells_of(const Column& column, const std::function<std::string(double)>& number, const std::string& none) {
  if (const auto* words = std::get_if<std::vector<std::string>>(&column.values)) return *words;
  Cells cells;
  for (const double value : std::get<std::vector<double>>(column.values))
    cells.push_back(std::isfinite(value) ? number(value) : none);
  return cells;
}

/// The cells of each row.
std::vector<Cells> rows_of(const std::vector<Cells>& columns) {
  std::vector<Cells> rows(columns.empty() ? 0 : columns.front().size());
  for (const auto& column : columns)
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].push_back(column[row]);
  return rows;
}

}  // namespace

std::string shortest(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string text_of(const Table& table) {
  std::vector<Cells> columns;
  for (const auto& column : table) {
    Cells cells = cells_of(column, ten_digits, "-");
    cells.insert(cells.begin(), column.name);
    const auto width = std::max_element(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
                         return a.size() < b.size();
                       })->size();
    for (auto& cell : cells) cell.resize(width, ' ');
    columns.push_back(std::move(cells));
  }
  std::string out;
  for (const auto& row : rows_of(columns)) {
    std::string line;
    for (const auto& cell : row) line += (line.empty() ? "" : "  ") + cell;
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return out;
}

std::string csv_of(const Table& table) {
  std::vector<Cells> columns;
  for (const auto& column : table) {
    columns.push_back(cells_of(column, shortest, ""));
    columns.back().insert(columns.back().begin(), column.name);
  }
  std::string out;
  for (const auto& row : rows_of(columns)) out += output::csv_line(row);
  return out;
}

nlohmann::ordered_json json_of(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json json_of(const Table& table) {
  auto out = nlohmann::ordered_json::object();
  for (const auto& column : table) {
    auto values = nlohmann::ordered_json::array();
    std::visit(
        [&](const auto& all) {
          for (const auto& each : all) {
            if constexpr (std::is_same_v<std::decay_t<decltype(each)>, double>) values.push_back(json_of(each));
            else values.push_back(each);
          }
        },
        column.values);
    out[column.name] = {{"unit", column.unit}, {"description", column.doc}, {"values", std::move(values)}};
  }
  return out;
}

}  // namespace talus::app
