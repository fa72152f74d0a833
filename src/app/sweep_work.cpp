#include "app/sweep_work.hpp"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/sweep_progress.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/text_file.hpp"

namespace talus::app {
namespace {

using core::ExitCode;
using sweep::Manifest;
using sweep::Status;
using sweep::SweepFolder;

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

/// 0: one on each core.
int jobs_of(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

std::string own_path() { return std::filesystem::canonical("/proc/self/exe").string(); }

SweepWork::SweepWork(const SweepPlan& plan, const std::string& source, const std::filesystem::path& out, bool force)
    : scenes_(plan.scenes),
      folder_(made(out), plan.scenes.size()),
      lock_(folder_.path(), "another sweep"),
      manifest_{plan.file.name, plan.file.title, source, plan.file.design, states_in(folder_, plan, force)} {
  write_scenes(folder_, plan);
  write_manifest(folder_.path(), manifest_);
}

ExitCode SweepWork::run(int jobs, int attempts) {
  const auto n_before = static_cast<std::size_t>(std::ranges::count_if(
      manifest_.members, [](const auto& state) { return sweep::next_action(state) == sweep::Action::skip; }));
  SweepProgress progress(manifest_.design, n_before, stderr);
  const int signal = run_members(manifest_, folder_, scenes_, {jobs_of(jobs), own_path(), attempts}, progress);
  progress.finish();
  return report(manifest_, folder_, n_before, signal != 0);
}

int SweepWork::run_once(int jobs, sweep::RunnerWatch& watch) {
  return run_members(manifest_, folder_, scenes_, {jobs_of(jobs), own_path(), 1, false}, watch);
}

}  // namespace talus::app
