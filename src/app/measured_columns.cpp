#include "app/measured_columns.hpp"

#include <algorithm>
#include <array>

#include "app/table.hpp"
#include "config/spelling.hpp"
#include "core/errors.hpp"

namespace talus::app {
namespace {

/// Spellings of a unit, ours first.
const std::vector<std::vector<std::string>> spellings{
    {"m", "meter", "meters", "metre", "metres"}, {"m/s", "m s-1", "m s^-1", "m.s-1", "meters per second"},
    {"s", "sec", "second", "seconds"},           {"kg", "kilogram", "kilograms"},
    {"kg/s", "kg s-1", "kg s^-1", "kg.s-1"},     {"degree", "degrees"}};

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& name, const std::string& what) {
  throw core::ConfigError(path.string() + ": " + name + ": " + what);
}

}  // namespace

bool is_netcdf(const std::filesystem::path& file) {
  static const std::array<std::string, 3> ends{".nc", ".nc4", ".cdf"};
  return std::ranges::find(ends, file.extension().string()) != ends.end();
}

bool is_unit(const std::string& written, const std::string& unit) {
  if (written == unit) return true;
  const auto known = std::ranges::find(spellings, unit, [](const auto& each) { return each.front(); });
  return known != spellings.end() && std::ranges::find(*known, written) != known->end();
}

output::VariableReader open_netcdf(const std::filesystem::path& path) {
  try {
    return output::VariableReader(path);
  } catch (const core::OutputError& error) {  // an input here
    throw core::ConfigError(error.what());
  }
}

output::StoredVariable read_variable(const output::VariableReader& file, const std::filesystem::path& path,
                                     const std::string& name, const config::CsvColumn& column) {
  const auto found = [&] {
    try {
      return file.read(name);
    } catch (const core::OutputError& error) { throw core::ConfigError(error.what()); }
  }();
  if (!found) {
    const auto guess = config::nearest(name, file.names());
    refuse(path, name,
           "no such variable" + (guess ? " (did you mean " + *guess + "?)" : std::string()) + "; expected " +
               column.expectation() + ": " + column.doc);
  }
  if (!is_unit(found->unit, column.unit))
    refuse(path, name, "expected the attribute units = \"" + column.unit + "\", found \"" + found->unit + "\"");
  for (std::size_t i = 0; i < found->values.size(); ++i)
    if (!column.accepts(found->values[i]))
      refuse(path, name + "[" + std::to_string(i) + "]",
             "expected " + column.expectation() + ", found " + shortest(found->values[i]));
  return *found;
}

std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                              const std::vector<config::CsvColumn>& columns,
                                              const std::vector<std::string>& names) {
  if (!is_netcdf(path)) return config::read_csv(path, columns);
  const auto file = open_netcdf(path);
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto variable = read_variable(file, path, names[i], columns[i]);
    if (variable.dimensions.size() != 1)
      refuse(path, names[i], "expected one dimension, found " + std::to_string(variable.dimensions.size()));
    if (!out.empty() && variable.values.size() != out.front().size())
      refuse(path, names[i],
             "expected " + std::to_string(out.front().size()) + " numbers, as " + names[0] + " has, found " +
                 std::to_string(variable.values.size()));
    out.push_back(variable.values);
  }
  return out;
}

}  // namespace talus::app
