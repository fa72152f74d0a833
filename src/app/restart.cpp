#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/memory.hpp"
#include "app/run.hpp"
#include "app/session.hpp"
#include "config/read.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

[[noreturn]] void refuse(const RunFolder& folder, const std::string& why) {
  throw core::OutputError(core::ExitCode::bad_restart, folder.path().string() + ": " + why);
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::ranges::find(list, word) != list.end();
}

void check_allowed_keys(const std::vector<std::string>& allowed) {
  for (const auto& key : allowed) {
    if (scene_schema().find(key) == nullptr)
      throw core::ConfigError("--allow: " + key + ": unknown key" + scene_schema().suggest_key(key));
  }
}

/// The summary of a run that has come to its end.
bool is_finished(const RunFolder& folder) {
  std::ifstream in(folder.summary());
  const auto summary = nlohmann::json::parse(in, nullptr, false);
  return summary.is_object() && summary.value("status", "") == "finished";
}

/// Where the scene differs from that of the checkpoint. Throws OutputError(bad_restart) where a difference is not allowed.
std::vector<config::Difference> check_differences(const RunFolder& folder, const std::string& file,
                                                  const std::string& before, const Scene& scene,
                                                  const std::vector<std::string>& allowed) {
  const auto differences = [&] {
    try {
      return config::differences(config::read_text(scene_schema(), before, "scene of " + file),
                                 config::read_text(scene_schema(), scene.effective, "scene.toml"));
    } catch (const core::ConfigError& error) {
      refuse(folder, file + " is of another version of Talus: " + error.what());
    }
  }();
  std::string refused;
  for (const auto& [key, was, is] : differences) {
    const auto words = [](const std::string& value) { return value.empty() ? "absent" : value; };
    if (!contains(allowed, key)) refused += "\n  " + key + ": " + words(was) + " there, " + words(is) + " here";
  }
  if (!refused.empty())
    refuse(folder, file + " was written for another scene (`--allow KEY` lets a key differ):" + refused);
  return differences;
}

void check_fit(const RunFolder& folder, const std::string& file, const output::Checkpoint& checkpoint,
               const Scene& scene, const Simulation& simulation) {
  if (!checkpoint.fits(simulation.system->layout()))
    refuse(folder, file + " holds the unknowns of another grid or model, which no --allow can bridge");
  if (scene.end < checkpoint.t)
    refuse(folder, "time.end = " + config::to_toml(scene.end) +
                       " s lies before the checkpoint at t = " + config::to_toml(checkpoint.t) + " s");
}

void tell(const RunFolder& folder, const output::CheckpointFolder::Found& found) {
  const std::string where = folder.path().string();
  for (const auto& damage : found.damaged)
    std::fprintf(stderr, "warning: %s: %s; the one before is taken\n", where.c_str(), damage.c_str());
  if (!found.checkpoint) {
    std::fprintf(stderr, "%s: no checkpoint yet, the run begins anew, with the scene.toml of that folder\n",
                 where.c_str());
    return;
  }
  std::fprintf(stderr, "%s: goes on from t = %.6g s with the scene.toml of that folder, whatever file it came from\n",
               where.c_str(), found.checkpoint->t);
  if (found.checkpoint->revision != output::git_revision())
    std::fprintf(stderr, "warning: %s was written by talus %s (%s): the bits may differ from an uninterrupted run's\n",
                 found.file.c_str(), found.checkpoint->talus_version.c_str(), found.checkpoint->revision.c_str());
}

}  // namespace

int restart(const RestartRequest& request) {
  const auto begun = std::chrono::steady_clock::now();
  Interrupt interrupt;
  check_allowed_keys(request.allowed);
  const RunFolder folder(request.folder, Claim::proceed);
  const Scene scene = read_scene(folder.scene(), request.overrides);
  auto found = folder.checkpoints().newest();
  if (!found.checkpoint && !found.damaged.empty())
    refuse(folder, found.damaged.front() + ", and no other checkpoint is whole; `talus run --force` begins anew");
  const std::string file = found.checkpoint ? found.file : "scene.toml";
  const std::string before = found.checkpoint ? found.checkpoint->scene : read_scene(folder.scene()).effective;
  const auto changes = check_differences(folder, file, before, scene, request.allowed);
  if (changes.empty() && is_finished(folder)) {
    std::printf("%s: finished already; to go further: --set time.end=SECONDS --allow time.end\n", scene.name.c_str());
    return 0;
  }
  const Simulation simulation = build_within_memory(scene);
  if (found.checkpoint) check_fit(folder, file, *found.checkpoint, scene, simulation);
  const Theory theory = theory_of(scene);
  tell(folder, found);

  if (found.checkpoint) {
    folder.checkpoints().remove_damaged(found);
    std::filesystem::remove(folder.summary());
  } else {
    folder.remove_results();
  }
  if (!changes.empty()) {
    if (found.checkpoint) {
      if (std::ranges::find(changes, "integrator.linear_solver", &config::Difference::key) != changes.end())
        found.checkpoint->linear_solver.clear();
      found.checkpoint->scene = scene.effective;
      folder.checkpoints().write(*found.checkpoint);  // so that the next restart finds the scene as it now is
    }
    output::write_atomically(folder.scene(), scene.effective);
  }
  return carry_out({scene, theory, simulation, folder, interrupt, request.command, begun,
                    found.checkpoint ? &*found.checkpoint : nullptr});
}

}  // namespace talus::app
