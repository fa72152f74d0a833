#pragma once

#include <algorithm>
#include <string_view>

namespace talus::config {

/// What a name must be to serve as one file name, one netCDF name and one word of a shell.
inline constexpr const char* plain_name = "letters, digits, - and _ only";

inline bool is_plain_name(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !name.empty() && name.front() != '-' && std::ranges::all_of(name, fits);
}

}  // namespace talus::config
