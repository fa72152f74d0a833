#include "sweep/member_state.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "output/text_file.hpp"

namespace talus::sweep {
namespace {

constexpr std::array<std::string_view, 5> words{"planned", "unfinished", "stopped", "failed", "finished"};

}  // namespace

std::string_view word_of(Status status) { return words.at(static_cast<std::size_t>(status)); }

MemberState member_state(const std::filesystem::path& folder, std::string_view scene) {
  MemberState state;
  if (!std::filesystem::exists(folder / "scene.toml")) return state;
  state.same_scene = output::contents(folder / "scene.toml") == scene;
  state.status = Status::unfinished;
  const auto summary = nlohmann::json::parse(output::contents(folder / "summary.json"), nullptr, false);
  if (!summary.is_object()) return state;
  const std::string status = summary.value("status", "");
  if (status == "finished") state.status = Status::finished;
  if (status == "stopped") state.status = Status::stopped;
  if (status == "failed") state.status = Status::failed;
  state.exit_code = summary.value("exit_code", -1);
  if (const auto reason = summary.find("reason"); reason != summary.end() && reason->is_string())
    state.reason = reason->get<std::string>();
  return state;
}

}  // namespace talus::sweep
