#include "config/number_csv.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>

#include "config/problems.hpp"
#include "config/spelling.hpp"

namespace talus::config {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line + ",");
  for (std::string cell; std::getline(in, cell, ',');) {
    const auto first = cell.find_first_not_of(" \t\r");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(" \t\r") - first + 1));
  }
  return cells;
}

std::optional<double> number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Which column stands where in the file.
std::vector<std::size_t> places_of(const std::vector<std::string>& header, const std::vector<CsvColumn>& columns,
                                   const std::string& place, Problems& problems) {
  std::vector<std::string> names;
  std::vector<std::size_t> places;
  for (const auto& column : columns) {
    names.push_back(column.name);
    const auto at = std::find(header.begin(), header.end(), column.name);
    places.push_back(static_cast<std::size_t>(at - header.begin()));
    if (at == header.end())
      problems.add(place, column.name, "missing column; expected " + column.expectation() + ": " + column.doc);
    else if (std::find(at + 1, header.end(), column.name) != header.end())
      problems.add(place, column.name, "stands in the header twice");
  }
  for (const auto& name : header) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const auto guess = nearest(name, names);
    problems.add(place, name, "unknown column" + (guess ? " (did you mean " + *guess + "?)" : std::string()));
  }
  return places;
}

}  // namespace

bool CsvColumn::accepts(double value) const {
  return (value > above || (or_equal && value == above)) && (value < below || (up_to && value == below));
}

std::string CsvColumn::expectation() const {
  std::ostringstream out;
  out << "a number";
  if (above > -1e300) out << (or_equal ? " at least " : " above ") << above;
  if (below < 1e300) out << (above > -1e300 ? " and" : "") << (up_to ? " at most " : " below ") << below;
  out << " [" << unit << "]";
  if (!why.empty()) out << " (" << why << ")";
  return out.str();
}

std::vector<std::vector<double>> read_csv(const std::filesystem::path& file, const std::vector<CsvColumn>& columns) {
  Problems problems;
  std::ifstream in(file);
  if (!in) problems.add(file.string(), "", "cannot be read");
  std::vector<std::vector<double>> values(columns.size());
  std::vector<std::string> header;
  std::vector<std::size_t> places;
  std::string line;
  for (int number_of_line = 1; std::getline(in, line); ++number_of_line) {
    const auto cells = cells_of(line);
    if (line.starts_with('#') || std::ranges::all_of(cells, [](const auto& cell) { return cell.empty(); })) continue;
    const std::string place = file.string() + ":" + std::to_string(number_of_line);
    if (header.empty()) {
      header = cells;
      places = places_of(header, columns, place, problems);
      problems.throw_if_any();
      continue;
    }
    if (cells.size() != header.size()) {
      problems.add(place, "",
                   "expected " + std::to_string(header.size()) + " cells, found " + std::to_string(cells.size()));
      continue;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto& cell = cells[places[i]];
      const auto value = number(cell);
      if (value && columns[i].accepts(*value)) values[i].push_back(*value);
      else problems.add(place, columns[i].name, "expected " + columns[i].expectation() + ", found '" + cell + "'");
    }
  }
  if (problems.none() && header.empty()) problems.add(file.string(), "", "has no header");
  problems.throw_if_any();
  return values;
}

}  // namespace talus::config
