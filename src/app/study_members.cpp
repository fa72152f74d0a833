#include "app/study_members.hpp"

#include "output/provenance.hpp"
#include "sweep/collection.hpp"

namespace talus::app {

SweepPlan plan_of(const MemberStudy& study, const Scene& scene) {
  SweepPlan plan{
      {scene.name + "_" + study.kind, study.what + ": " + (scene.title.empty() ? scene.name : scene.title),
       study.scene_file, settings_beside(study.dimension, study.overrides), sweep::Design({study.dimension})},
      {}};
  plan.scenes = member_scenes(plan.file, "study " + study.kind + " " + study.scene_file.string());
  return plan;
}

output::Table table_of(const std::string& kind, const std::filesystem::path& folder, const sweep::Manifest& manifest,
                       const std::string& command, const std::string& verdict) {
  auto table = sweep::collect(folder, manifest, {}).table;
  auto provenance = output::provenance_attributes({"", command, {}});
  provenance.erase("scene");  // each member has its own
  table.attributes.merge(provenance);
  table.attributes["study"] = kind;
  table.attributes["verdict"] = verdict;
  return table;
}

}  // namespace talus::app
