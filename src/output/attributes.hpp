#pragma once

#include <map>
#include <string>
#include <variant>

namespace talus::output {

/// The value of a netCDF attribute.
using Attribute = std::variant<std::string, double, int>;
/// Attributes of a file by name.
using Attributes = std::map<std::string, Attribute>;

}  // namespace talus::output
