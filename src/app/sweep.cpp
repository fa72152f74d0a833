#include "app/sweep.hpp"

#include <cstdio>

#include "app/run.hpp"
#include "app/sweep_plan.hpp"
#include "app/sweep_work.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/text_file.hpp"
#include "sweep/runner.hpp"

namespace talus::app {
namespace {

using sweep::Manifest;
using sweep::SweepFolder;

void describe(const SweepPlan& plan) {
  const auto& design = plan.file.design;
  std::printf("%s: %zu members, all scenes checked\n", plan.file.name.c_str(), design.size());
  for (const auto& dimension : design.dimensions()) {
    std::printf("  %s: %zu\n", dimension.name.c_str(), dimension.size());
    for (const auto& axis : dimension.axes) {
      std::printf("    %s: %s ... %s\n", sweep::heading(axis).c_str(), sweep::plain(axis.values.front()).c_str(),
                  sweep::plain(axis.values.back()).c_str());
    }
  }
}

/// Puts the script in the folder, where marks of an earlier one would be wrong, and says how to start it.
void write_script(sweep::Engine engine, const SweepFolder& folder, const Manifest& manifest) {
  const auto script = script_for(engine, {manifest.name, manifest.members.size(), own_path(),
                                          std::filesystem::absolute(folder.path()).lexically_normal().string()});
  for (const char* mark : {"parallel.log", "done"}) std::filesystem::remove_all(folder.path() / mark);
  const auto file = folder.path() / script.file;
  output::write_atomically(file, script.text);
  if (script.executable) {
    using std::filesystem::perms;
    permissions(file, perms::owner_exec | perms::group_exec | perms::others_exec, std::filesystem::perm_options::add);
  }
  std::printf("%s: %zu members prepared; to run them:\n%s\n", manifest.name.c_str(), manifest.members.size(),
              script.start.c_str());
}

}  // namespace

int sweep(const SweepRequest& request) {
  const SweepPlan plan = plan_sweep(request.file, request.overrides);
  if (request.dry_run) {
    describe(plan);
    return 0;
  }
  SweepWork work(plan, request.file.string(), request.out.value_or(std::filesystem::path("out") / plan.file.name),
                 request.force);
  if (request.engine) {
    write_script(*request.engine, work.folder(), work.manifest());
    return 0;
  }
  return static_cast<int>(work.run(request.jobs));
}

int run_member(const std::filesystem::path& folder, std::size_t member, const std::string& command) {
  const Manifest manifest = sweep::read_manifest(folder);
  if (member >= manifest.members.size()) {
    throw core::ConfigError(folder.string() + ": expected a member from 0 to " +
                            std::to_string(manifest.members.size() - 1) + ", found " + std::to_string(member));
  }
  const SweepFolder place(folder, manifest.members.size());
  const auto run_folder = folder / place.member(member);
  const auto state = sweep::member_state(run_folder, output::contents(folder / place.scene(member)));
  switch (sweep::next_action(state)) {
    case sweep::Action::skip: std::printf("%s: finished before\n", place.member(member).c_str()); return 0;
    case sweep::Action::restart: return restart({run_folder, {}, {}, command});
    case sweep::Action::run: break;
  }
  if (!state.damage.empty())
    std::fprintf(stderr, "warning: %s: %s, and no other checkpoint is whole: it begins anew\n",
                 place.member(member).c_str(), state.damage.c_str());
  RunRequest request;
  request.scene_file = folder / place.scene(member);
  request.out = run_folder;
  request.force = true;
  request.command = command;
  return run(request);
}

}  // namespace talus::app
