#pragma once

#include <filesystem>
#include <string_view>

namespace talus::output {

/// Puts `text` at `path` in one piece: written beside it, brought to disk, then renamed over it. A reader, or a crash
/// at any moment, finds the old text or the new one, never a part. Throws OutputError(output_failed), leaving `path` as
/// it was.
void write_atomically(const std::filesystem::path& path, std::string_view text);

/// A path beside `path` for what is to take its place: "run.nc.part-" and the number of this process.
[[nodiscard]] std::filesystem::path aside(const std::filesystem::path& path);

/// Brings what was written to a file to disk. Throws OutputError(output_failed).
void bring_to_disk(const std::filesystem::path& path);

}  // namespace talus::output
