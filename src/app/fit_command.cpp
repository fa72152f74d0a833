#include "app/fit_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/fit_report.hpp"
#include "app/fit_runs.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"

namespace talus::app {
namespace {

struct Request {
  std::filesystem::path file, out;
  std::vector<std::string> overrides;
  bool json = false;
  int jobs = 0;
  bool force = false;
  std::string command;
};

void act(const Request& request) {
  const FitFile file = read_fit(request.file, request.overrides);
  const auto folder = request.out.empty() ? std::filesystem::path("out") / file.name : request.out;
  const auto answer = [&] {
    try {
      if (!file.layer) return fit::fit(file.problem);
      FitRuns runs(file, folder / "stage_2", request.jobs, request.force);
      return fit::fit(file.problem, file.layer->stage, runs);
    } catch (const std::domain_error& error) {  // of a search for a root
      throw core::Error(core::ExitCode::solver, std::string("fit: ") + error.what());
    }
  }();
  const std::string json = fit_json(file, answer).dump(1) + "\n";
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw core::OutputError(core::ExitCode::io_setup, folder.string() + ": cannot be created: " + failure.message());
  output::write_atomically(folder / "fit.json", json);
  if (answer) write_fit_file(folder / "fit.nc", file, *answer, request.command);
  else std::filesystem::remove(folder / "fit.nc", failure);  // of an earlier fit, which is no answer to this one
  std::fputs((request.json ? json : fit_text(file, answer)).c_str(), stdout);
}

}  // namespace

void add_fit_command(CLI::App& program, const std::string& command) {
  const auto request = std::make_shared<Request>();
  request->command = command;
  auto* fit =
      program.add_subcommand("fit", "the friction law and channel from slopes and speed profiles of steady heaps");
  fit->add_option("file", request->file, "fit file (TOML); talus explain fit, unknown, slopes, profile, stage_2")
      ->required()
      ->type_name("FIT.toml");
  fit->add_option("--set", request->overrides, "replace a value of [fit]; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  fit->add_option("--out", request->out, "folder for fit.json and fit.nc; default out/<fit.name>")->type_name("DIR");
  fit->add_option("--jobs", request->jobs, "runs of stage 2 at a time; default: one on each core")
      ->check(CLI::Range(1, 4096));
  fit->add_flag("--force", request->force, "replace runs of other scenes in the folder of stage 2");
  fit->add_flag("--json", request->json, "JSON instead of tables");
  fit->footer(
      "Examples:\n"
      "  talus fit runs/studies/fit_table_2/three_slopes.toml\n"
      "  talus plot out/three_slopes                    # the page of pictures, fit.png\n"
      "With [stage_2], data of a heap in time are fitted by runs of its scene, in DIR/stage_2; a fit that was stopped "
      "or "
      "killed goes on with the same command.\n"
      "Where no parameters between the bounds let every flow measured be steady, the answer says so, and the exit code "
      "is 0.");
  fit->callback([request] { act(*request); });
}

}  // namespace talus::app
