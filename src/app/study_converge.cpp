#include "app/study_converge.hpp"

#include <cstdio>

#include "app/convergence_report.hpp"
#include "app/plot.hpp"
#include "app/refinement.hpp"
#include "app/sweep_work.hpp"
#include "output/atomic_file.hpp"
#include "output/provenance.hpp"
#include "sweep/collection.hpp"

namespace talus::app {
namespace {

SweepPlan plan_of(const ConvergeRequest& request, const Scene& scene, const Refinement& refinement) {
  const auto levels = levels_of(scene, refinement, request.levels);
  SweepPlan plan{{scene.name + "_converge",
                  "Refinement in " + refinement.words() + " of: " + (scene.title.empty() ? scene.name : scene.title),
                  request.scene_file, settings_beside(levels, request.overrides), sweep::Design({levels})},
                 {}};
  plan.scenes = member_scenes(plan.file, "study converge " + request.scene_file.string());
  return plan;
}

std::vector<double> rtols_of(const SweepPlan& plan) {
  std::vector<double> rtols;
  for (const auto& scene : plan.scenes) rtols.push_back(read_scene_text(scene, plan.file.name).integration.rtol);
  return rtols;
}

void write(const ConvergenceStudy& study, const sweep::Manifest& manifest, const std::filesystem::path& folder,
           const ConvergeRequest& request) {
  auto table = sweep::collect(folder, manifest, {}).table;
  auto provenance = output::provenance_attributes({"", request.command, {}});
  provenance.erase("scene");  // each level has its own
  table.attributes.merge(provenance);
  table.attributes["study"] = "converge";
  table.attributes["verdict"] = sentence_of(study);
  add_to(table, study);
  write_table(folder / "study.nc", table);
  output::write_atomically(folder / "verdict.json", json_text_of(study));
}

}  // namespace

int study_converge(const ConvergeRequest& request) {
  const Scene scene = read_scene(request.scene_file, request.overrides);
  const auto refinement = refinement_of(request.directions, scene);
  const SweepPlan plan = plan_of(request, scene, refinement);
  SweepWork work(plan, request.scene_file.string(), request.out.value_or(std::filesystem::path("out") / plan.file.name),
                 request.force);
  const auto code = work.run(request.jobs);
  if (code == core::ExitCode::restartable) {
    std::printf("%s: the same command goes on\n", plan.file.name.c_str());
    return static_cast<int>(code);
  }
  const auto& folder = work.folder().path();
  const auto study = read_convergence_study(folder, work.manifest(), rtols_of(plan));
  write(study, work.manifest(), folder, request);
  std::printf("\n%s", text_of(study).c_str());
  std::fflush(stdout);
  draw_study(folder);
  return static_cast<int>(code);
}

}  // namespace talus::app
