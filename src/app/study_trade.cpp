#include "app/study_trade.hpp"

#include <cstdio>

#include "app/plot.hpp"
#include "app/study_members.hpp"
#include "app/sweep_work.hpp"
#include "app/trade_report.hpp"
#include "output/atomic_file.hpp"

namespace talus::app {
namespace {

void write(const TradeStudy& study, const sweep::Manifest& manifest, const std::filesystem::path& folder,
           const TradeRequest& request) {
  auto table = table_of("trade", folder, manifest, request.command, advice_of(study));
  add_to(table, study);
  write_table(folder / "study.nc", table);
  output::write_atomically(folder / "trade.csv", csv_of(study));
  output::write_atomically(folder / "verdict.json", json_text_of(study));
}

}  // namespace

int study_trade(const TradeRequest& request) {
  const Scene scene = read_scene(request.scene_file, request.overrides);
  const auto choices = trade_choices(scene);
  const auto dimension = dimension_of(choices, scene);
  const SweepPlan plan =
      plan_of({"trade", "Cost and error of the choices for", request.scene_file, request.overrides, dimension}, scene);
  SweepWork work(plan, request.scene_file.string(), request.out.value_or(std::filesystem::path("out") / plan.file.name),
                 request.force);
  const auto code = work.run(request.jobs);
  if (code == core::ExitCode::restartable) {
    std::printf("%s: the same command goes on\n", plan.file.name.c_str());
    return static_cast<int>(code);
  }
  const auto& folder = work.folder().path();
  const auto study = read_trade_study(folder, work.manifest(), scene, choices, request.by);
  write(study, work.manifest(), folder, request);
  std::printf("\n%s", text_of(study).c_str());
  std::fflush(stdout);
  draw_study(folder);
  return 0;
}

}  // namespace talus::app
