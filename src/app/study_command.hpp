#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace talus::app {

/// Adds `talus study` with its kinds of studies; `code` takes the exit code. `command`: as typed, for the provenance.
void add_study_command(CLI::App& program, const std::string& command, int& code);

}  // namespace talus::app
