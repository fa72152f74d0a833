#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/values.hpp"

namespace talus::config {

/// Reads a TOML scene against a schema. Refused are unknown, duplicate, missing, mistyped, out-of-range and non-finite
/// values and unknown words; an integer passes for a number. `overrides` are "key=value" texts that replace or add
/// values and pass the same checks; words and texts need no quotes there.
/// Throws core::ConfigError that names every problem found, each as "file:line:column: key: what was expected [unit]".
Values read(const Schema& schema, const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// As `read`, from text; `name` stands for the file in messages.
Values read_text(const Schema& schema, std::string_view toml, const std::string& name,
                 const std::vector<std::string>& overrides = {});

}  // namespace talus::config
