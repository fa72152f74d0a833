#include "app/study_converge.hpp"

#include <cstdio>

#include "app/convergence_report.hpp"
#include "app/plot.hpp"
#include "app/refinement.hpp"
#include "app/study_members.hpp"
#include "app/sweep_work.hpp"
#include "output/atomic_file.hpp"

namespace talus::app {
namespace {

std::vector<double> rtols_of(const SweepPlan& plan) {
  std::vector<double> rtols;
  for (const auto& scene : plan.scenes) rtols.push_back(read_scene_text(scene, plan.file.name).integration.rtol);
  return rtols;
}

void write(const ConvergenceStudy& study, const sweep::Manifest& manifest, const std::filesystem::path& folder,
           const ConvergeRequest& request) {
  auto table = table_of("converge", folder, manifest, request.command, sentence_of(study));
  add_to(table, study);
  write_table(folder / "study.nc", table);
  output::write_atomically(folder / "verdict.json", json_text_of(study));
}

}  // namespace

int study_converge(const ConvergeRequest& request) {
  const Scene scene = read_scene(request.scene_file, request.overrides);
  const auto refinement = refinement_of(request.directions, scene);
  const auto levels = levels_of(scene, refinement, request.levels);
  const SweepPlan plan = plan_of(
      {"converge", "Refinement in " + refinement.words() + " of", request.scene_file, request.overrides, levels},
      scene);
  SweepWork work(plan, request.scene_file.string(), request.out.value_or(std::filesystem::path("out") / plan.file.name),
                 request.force);
  const auto code = work.run(request.jobs);
  if (code == core::ExitCode::restartable) {
    std::printf("%s: the same command goes on\n", plan.file.name.c_str());
    return static_cast<int>(code);
  }
  const auto& folder = work.folder().path();
  const auto study = read_convergence_study(folder, work.manifest(), scene, rtols_of(plan));
  write(study, work.manifest(), folder, request);
  std::printf("\n%s", text_of(study).c_str());
  std::fflush(stdout);
  draw_study(folder);
  return static_cast<int>(code);
}

}  // namespace talus::app
