#pragma once

#include <string>

namespace CLI {
class App;
}

namespace talus::app {

/// Adds `talus fit`. `command`: the command line as typed, for the provenance.
void add_fit_command(CLI::App& program, const std::string& command);

}  // namespace talus::app
