#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::output {

/// Reads the series of a run.nc, what was recorded along `series_time`, and the last record of its fields. The file is trusted: it
/// is one of ours.
class RunReader {
 public:
  struct Description {
    std::string unit;
    std::string long_name;
  };

  /// One record of a field or a line: row-major, shape (n_layers, n_columns), 1 where it has no such dimension.
  struct Cells {
    std::size_t n_layers = 1;
    std::size_t n_columns = 1;
    std::vector<double> values;
  };

  /// Throws core::OutputError(io_setup) for a file that is not there or cannot be read.
  explicit RunReader(const std::filesystem::path& path);
  RunReader(const RunReader&) = delete;
  RunReader& operator=(const RunReader&) = delete;
  ~RunReader();

  /// Names of the single numbers along series_time.
  [[nodiscard]] const std::vector<std::string>& series() const { return series_; }
  /// Names of what has a value a cell, a column or a layer along `time`; coordinates and flags are none of them.
  [[nodiscard]] const std::vector<std::string>& fields() const { return fields_; }
  /// Of any variable; nothing where there is none.
  [[nodiscard]] std::optional<Description> describe(const std::string& name) const;
  /// All records of a series, or of series_time itself. Throws core::OutputError(io_setup).
  [[nodiscard]] std::vector<double> values(const std::string& name) const;
  /// The last record of one of fields(). Throws core::OutputError(io_setup).
  [[nodiscard]] Cells last_record(const std::string& name) const;

 private:
  [[nodiscard]] bool is_field(int id) const;
  [[nodiscard]] std::string text(int variable, const char* attribute) const;
  std::filesystem::path path_;
  int file_ = -1;
  std::vector<std::string> series_, fields_;
};

}  // namespace talus::output
