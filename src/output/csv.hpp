#pragma once

#include <span>
#include <string>

namespace talus::output {

/// One line of a CSV file (RFC 4180), with its line feed: fields that hold a comma, a quote or a line break are quoted.
std::string csv_line(std::span<const std::string> fields);

}  // namespace talus::output
