#pragma once

#include <filesystem>
#include <optional>

namespace talus::app {

/// Draws the pictures of a run, and a movie if wanted, into its folder, or the page of a study: runs the Python program in
/// src/plot, without a shell, and waits for it. Returns its exit code. Throws core::ConfigError for a folder without run or study,
/// core::OutputError(io_setup) where Python cannot be started or is killed.
int plot(const std::filesystem::path& folder, bool movie);

/// Writes the report of a run, one HTML page that needs nothing else, to `out`, by default report.html in its folder. Exit code
/// and errors as plot().
int report(const std::filesystem::path& folder, const std::optional<std::filesystem::path>& out);

/// The page of a study that has just been written. Where it cannot be drawn a warning says so: the numbers are there.
void draw_study(const std::filesystem::path& folder);

}  // namespace talus::app
