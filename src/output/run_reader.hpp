#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::output {

/// Reads the series of a run.nc: what was recorded along `series_time`. The file is trusted: it is one of ours.
class RunReader {
 public:
  struct Description {
    std::string unit;
    std::string long_name;
  };

  /// Throws core::OutputError(io_setup) for a file that is not there or cannot be read.
  explicit RunReader(const std::filesystem::path& path);
  RunReader(const RunReader&) = delete;
  RunReader& operator=(const RunReader&) = delete;
  ~RunReader();

  /// Names of the single numbers along series_time.
  [[nodiscard]] const std::vector<std::string>& series() const { return series_; }
  /// Of any variable; nothing where there is none.
  [[nodiscard]] std::optional<Description> describe(const std::string& name) const;
  /// All records of a series, or of series_time itself. Throws core::OutputError(io_setup).
  [[nodiscard]] std::vector<double> values(const std::string& name) const;

 private:
  [[nodiscard]] std::string text(int variable, const char* attribute) const;
  std::filesystem::path path_;
  int file_ = -1;
  std::vector<std::string> series_;
};

}  // namespace talus::output
