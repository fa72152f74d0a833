#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/number_csv.hpp"
#include "output/variable_reader.hpp"

namespace talus::app {

/// Whether a file's name ends as netCDF files' do: .nc, .nc4, .cdf.
[[nodiscard]] bool is_netcdf(const std::filesystem::path& file);

/// Whether a netCDF unit is another spelling of one of ours: "m s-1" for "m/s".
[[nodiscard]] bool is_unit(const std::string& written, const std::string& unit);

/// Throws core::ConfigError for a file that is not there or is not netCDF.
[[nodiscard]] output::VariableReader open_netcdf(const std::filesystem::path& path);

/// A variable of a netCDF file in the unit of `column`, which has its range and what it is. Throws core::ConfigError naming file and variable
/// where there is none, its unit is another, or a number is out of range.
[[nodiscard]] output::StoredVariable read_variable(const output::VariableReader& file,
                                                   const std::filesystem::path& path, const std::string& name,
                                                   const config::CsvColumn& column);

/// Columns of measurements from a CSV file, or from a netCDF file whose variables are called `names`, in the order of `columns`,
/// along one dimension. Throws core::ConfigError.
[[nodiscard]] std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                                            const std::vector<config::CsvColumn>& columns,
                                                            const std::vector<std::string>& names);

}  // namespace talus::app
