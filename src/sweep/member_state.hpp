#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace talus::sweep {

enum class Status : std::uint8_t {
  planned,     ///< nothing there
  unfinished,  ///< begun without a summary: running, or killed
  stopped,     ///< ended early on demand
  failed,
  finished
};
/// As in the manifest: "planned" and so on.
std::string_view word_of(Status status);

/// What a run folder says of its run.
struct MemberState {
  Status status = Status::planned;
  int exit_code = -1;      ///< -1 where there is no summary
  std::string reason;      ///< why it stopped or failed
  bool same_scene = true;  ///< false where the run is one of another scene
  bool goes_on = false;  ///< it did not fail by itself (stopped, killed, disk full), and a whole checkpoint lies there
  std::string damage;    ///< what is wrong with the newest checkpoint where none is whole
};

/// Reads the folder's scene.toml, summary.json and, of a run that is not finished, checkpoints. `scene` is the effective scene that the member should have.
MemberState member_state(const std::filesystem::path& folder, std::string_view scene);

}  // namespace talus::sweep
