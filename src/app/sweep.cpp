#include "app/sweep.hpp"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/run.hpp"
#include "app/sweep_plan.hpp"
#include "app/sweep_progress.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/folder_lock.hpp"
#include "output/text_file.hpp"
#include "sweep/manifest.hpp"
#include "sweep/runner.hpp"
#include "sweep/sweep_folder.hpp"

namespace talus::app {
namespace {

using core::ExitCode;
using sweep::Manifest;
using sweep::Status;
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

std::filesystem::path made(const std::filesystem::path& folder) {
  std::error_code error;
  for (const char* part : {"members", "scenes"}) {
    std::filesystem::create_directories(folder / part, error);
    if (error) {
      throw core::OutputError(ExitCode::io_setup,
                              "output folder " + folder.string() + ": cannot be created: " + error.message());
    }
  }
  return folder;
}

/// What the folder holds already of each member.
std::vector<sweep::MemberState> states_in(const SweepFolder& folder, const SweepPlan& plan, bool force) {
  std::vector<sweep::MemberState> states;
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    states.push_back(sweep::member_state(folder.path() / folder.member(i), plan.scenes[i]));
    if (!states.back().same_scene && !force) {
      throw core::OutputError(ExitCode::io_setup, (folder.path() / folder.member(i)).string() +
                                                      " holds a run of another scene than member " + std::to_string(i) +
                                                      " (" + plan.file.design.describe(i) +
                                                      "); --force runs such members again, --out names another folder");
    }
  }
  return states;
}

void write_scenes(const SweepFolder& folder, const SweepPlan& plan) {
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    const auto file = folder.path() / folder.scene(i);
    if (output::contents(file) != plan.scenes[i]) output::write_atomically(file, plan.scenes[i]);
  }
}

/// Prints what became of the members; the exit code that follows from it.
ExitCode report(const Manifest& manifest, const SweepFolder& folder, std::size_t n_before, bool interrupted) {
  const auto count = [&](Status status) {
    return std::ranges::count(manifest.members, status, &sweep::MemberState::status);
  };
  const auto n_finished = count(Status::finished), n_failed = count(Status::failed);
  const auto n_left = static_cast<long>(manifest.members.size()) - n_finished - n_failed;
  for (std::size_t i = 0; i < manifest.members.size(); ++i) {
    const auto& member = manifest.members[i];
    if (member.status != Status::failed) continue;
    std::printf("%s failed with exit code %d: %s\n  %s\n", folder.member(i).c_str(), member.exit_code,
                manifest.design.describe(i).c_str(), member.reason.substr(0, member.reason.find('\n')).c_str());
  }
  std::printf(
      "%s: %zu members: %ld finished (%zu of them before), %ld failed, %ld not run to their end; results in %s\n",
      manifest.name.c_str(), manifest.members.size(), n_finished, n_before, n_failed, n_left, folder.path().c_str());
  if (n_failed > 0 && !interrupted) return ExitCode::members_failed;
  return n_left > 0 || n_failed > 0 ? ExitCode::restartable : ExitCode::ok;
}

std::string own_path() { return std::filesystem::canonical("/proc/self/exe").string(); }

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

int jobs_of(const SweepRequest& request) {
  return request.jobs > 0 ? request.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

int sweep(const SweepRequest& request) {
  const SweepPlan plan = plan_sweep(request.file, request.overrides);
  if (request.dry_run) {
    describe(plan);
    return 0;
  }
  const SweepFolder folder(made(request.out.value_or(std::filesystem::path("out") / plan.file.name)),
                           plan.scenes.size());
  const output::FolderLock lock(folder.path(), "another sweep");
  Manifest manifest{plan.file.name, plan.file.title, request.file.string(), plan.file.design,
                    states_in(folder, plan, request.force)};
  write_scenes(folder, plan);
  write_manifest(folder.path(), manifest);
  if (request.engine) {
    write_script(*request.engine, folder, manifest);
    return 0;
  }
  const auto n_before = static_cast<std::size_t>(std::ranges::count_if(
      manifest.members, [](const auto& state) { return sweep::next_action(state) == sweep::Action::skip; }));
  SweepProgress progress(manifest.design, n_before, stderr);
  const int signal = run_members(manifest, folder, plan.scenes, {jobs_of(request), own_path()}, progress);
  progress.finish();
  return static_cast<int>(report(manifest, folder, n_before, signal != 0));
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
