#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::config {

/// A column that a CSV file must have. Its name ends in its unit, as zeta_deg or h_stop_m, so that a file in other units
/// is refused by its header.
struct CsvColumn {
  std::string name, unit, doc;
  double above, below;    ///< numbers lie strictly between
  bool or_equal = false;  ///< `above` itself is allowed, too
  bool up_to = false;     ///< and `below`
  std::string why{};      ///< of the range, in words, for messages

  [[nodiscard]] bool accepts(double value) const;
  /// "a number above 0 and below 90 [degree]".
  [[nodiscard]] std::string expectation() const;
};

/// Rows of numbers under a header that names exactly these columns, in any order; empty lines and those that start with
/// # are skipped. Returns one vector a column, in the order of `columns`. Throws core::ConfigError with file:line and
/// column for whatever is not as declared, all of it at once.
[[nodiscard]] std::vector<std::vector<double>> read_csv(const std::filesystem::path& file,
                                                        const std::vector<CsvColumn>& columns);

}  // namespace talus::config
