#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::output {

/// A variable of a netCDF file with all its numbers, row-major.
struct StoredVariable {
  std::string unit;  ///< "" where it states none
  std::vector<std::string> dimensions;
  std::vector<std::size_t> lengths;
  std::vector<double> values;  ///< NaN where the file has a fill value
};

/// Reads whole variables of any netCDF file, ours or another's.
class VariableReader {
 public:
  /// Throws OutputError(io_setup) for a file that is not there or is not netCDF.
  explicit VariableReader(const std::filesystem::path& path);
  VariableReader(const VariableReader&) = delete;
  VariableReader& operator=(const VariableReader&) = delete;
  ~VariableReader();

  /// Names of the variables that hold numbers.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Nothing where there is none of that name. Throws OutputError(io_setup) for one that cannot be read, or is packed.
  [[nodiscard]] std::optional<StoredVariable> read(const std::string& name) const;

 private:
  std::filesystem::path path_;
  int file_ = -1;
  std::vector<std::string> names_;
};

}  // namespace talus::output
