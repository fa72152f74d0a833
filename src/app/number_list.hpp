#pragma once

#include <string>
#include <vector>

namespace talus::app {

/// The numbers of a command-line list: single ones and ranges, separated by commas.
///
///     30,45         two numbers
///     30:50:5       30, 35, ... up to 50, in steps of 5 (the end is taken where a step meets it within rounding)
///     1e-4:10:x21   21 numbers from 1e-4 to 10, each a constant factor above the last
///
/// Throws core::ConfigError naming `option`, what was found and what is expected; `unit` is shown there. At most a
/// million numbers.
std::vector<double> number_list(const std::string& text, const std::string& option, const std::string& unit);

}  // namespace talus::app
