#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "output/attributes.hpp"

namespace talus::output {

/// A variable that is known whole, row-major. NaN marks a missing number.
struct TableVariable {
  std::string name;
  std::vector<std::string> dimensions;  ///< slowest first
  std::string unit;                     ///< UDUNITS, "1" for none; "" leaves the attribute away
  std::string long_name;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;
  Attributes attributes{};
  std::vector<std::string> flags{};  ///< words for the integers 0, 1, ...: flag_values and flag_meanings of CF
};

struct Table {
  std::vector<std::pair<std::string, std::size_t>> dimensions;
  std::vector<TableVariable> variables;
  Attributes attributes;
};

/// Writes a netCDF-4 file (CF-1.8) in one piece, replacing an earlier one. Throws OutputError(output_failed), leaving that
/// as it was; Error(internal) for a variable whose values do not fill its dimensions.
void write_table(const std::filesystem::path& path, const Table& table);

}  // namespace talus::output
