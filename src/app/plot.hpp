#pragma once

#include <filesystem>

namespace talus::app {

/// Draws the pictures of a run, and a movie if wanted, into its folder: runs the Python program in src/plot, without a
/// shell, and waits for it. Returns its exit code. Throws core::ConfigError for a folder without a run,
/// core::OutputError(io_setup) where Python cannot be started or is killed.
int plot(const std::filesystem::path& folder, bool movie);

}  // namespace talus::app
