#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace talus::app {

/// Adds `talus steady` to the program; `command` is the command line as typed, for the provenance of files.
void add_steady_command(CLI::App& program, const std::string& command);

}  // namespace talus::app
