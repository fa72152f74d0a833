#include "sweep/member_state.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "core/errors.hpp"
#include "output/checkpoint_folder.hpp"
#include "output/text_file.hpp"

namespace talus::sweep {
namespace {

constexpr std::array<std::string_view, 5> words{"planned", "unfinished", "stopped", "failed", "finished"};

/// Stopped, killed (no summary), or out of disk: what it had saved is as good as on the day.
bool did_not_fail_by_itself(const MemberState& state) {
  using core::ExitCode;
  return state.exit_code < 0 || state.exit_code == static_cast<int>(ExitCode::restartable) ||
         state.exit_code == static_cast<int>(ExitCode::output_failed);
}

void read_summary(const std::filesystem::path& file, MemberState& state) {
  const auto summary = nlohmann::json::parse(output::contents(file), nullptr, false);
  if (!summary.is_object()) return;
  const std::string status = summary.value("status", "");
  if (status == "finished") state.status = Status::finished;
  if (status == "stopped") state.status = Status::stopped;
  if (status == "failed") state.status = Status::failed;
  state.exit_code = summary.value("exit_code", -1);
  if (const auto reason = summary.find("reason"); reason != summary.end() && reason->is_string())
    state.reason = reason->get<std::string>();
}

void read_checkpoints(const std::filesystem::path& folder, std::string_view scene, MemberState& state) {
  try {
    const auto found = output::CheckpointFolder(folder).newest();
    state.goes_on = found.checkpoint && found.checkpoint->scene == scene;
    if (!found.checkpoint && !found.damaged.empty()) state.damage = found.damaged.front();
  } catch (const core::OutputError& error) { state.damage = error.what(); }
}

}  // namespace

std::string_view word_of(Status status) { return words.at(static_cast<std::size_t>(status)); }

MemberState member_state(const std::filesystem::path& folder, std::string_view scene) {
  MemberState state;
  if (!std::filesystem::exists(folder / "scene.toml")) return state;
  state.same_scene = output::contents(folder / "scene.toml") == scene;
  state.status = Status::unfinished;
  read_summary(folder / "summary.json", state);
  if (state.same_scene && state.status != Status::finished && did_not_fail_by_itself(state))
    read_checkpoints(folder, scene, state);
  return state;
}

}  // namespace talus::sweep
