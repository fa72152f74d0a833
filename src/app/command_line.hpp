#pragma once

namespace talus::app {

/// The whole program: reads the command line, does what it says, prints errors on stderr. Returns the exit code: see
/// core::ExitCode; 128 + signal after a run that was stopped. Never throws.
int command_line(int argc, const char* const* argv) noexcept;

}  // namespace talus::app
