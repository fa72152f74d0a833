#include "app/command_line.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "app/check.hpp"
#include "app/collect.hpp"
#include "app/exit_code.hpp"
#include "app/fit_command.hpp"
#include "app/fit_file.hpp"
#include "app/hstop.hpp"
#include "app/list.hpp"
#include "app/plot.hpp"
#include "app/presets.hpp"
#include "app/rheology.hpp"
#include "app/run.hpp"
#include "app/scene.hpp"
#include "app/steady_command.hpp"
#include "app/study_command.hpp"
#include "app/sweep.hpp"
#include "app/versions.hpp"
#include "sweep/sweep_file.hpp"

namespace talus::app {
namespace {

void print(const std::string& text) { std::fputs(text.c_str(), stdout); }

std::string joined(int argc, const char* const* argv) {
  std::string command;
  for (int i = 0; i < argc; ++i) command += (i > 0 ? " " : "") + std::string(argv[i]);
  return command;
}

/// Of one section of a scene, a sweep file or a fit file, of the presets, or of all sections.
std::string explanation(const std::string& section) {
  if (section == "presets") return explain_presets();
  const auto& sweeps = sweep::sweep_schema();
  if (section.empty()) return explain(scene_schema()) + "\n" + explain(sweeps) + "\n" + explain(fit_schema());
  if (fit_schema().find_section(section) != nullptr) return explain(fit_schema(), section);
  return explain(sweeps.find_section(section) != nullptr ? sweeps : scene_schema(), section);
}

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "replace a value of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

const std::map<std::string, sweep::Engine> engines{{"gnu-parallel", sweep::Engine::gnu_parallel},
                                                   {"slurm", sweep::Engine::slurm},
                                                   {"snakemake", sweep::Engine::snakemake}};

void add_sweep(CLI::App& program, SweepRequest& request, int& code) {
  auto* command = program.add_subcommand("sweep", "run a scene over axes of its keys, many runs at a time");
  command->add_option("sweep", request.file, "sweep file (TOML); talus explain sweep")
      ->required()
      ->type_name("SWEEP.toml");
  add_overrides(*command, request.overrides);
  command->add_option("--out", request.out, "folder of the sweep; default out/<sweep.name>")->type_name("DIR");
  command->add_option("--jobs", request.jobs, "members at a time; default one on each core")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  command->add_flag("--force", request.force, "run members again whose scene has changed");
  command->add_flag("--dry-run", request.dry_run, "check all members and say what they are, run nothing");
  command
      ->add_option("--write", request.engine,
                   "run nothing, write a script that does: gnu-parallel, slurm (job array) or snakemake")
      ->type_name("ENGINE")
      ->transform(CLI::CheckedTransformer(engines));
  command->callback([&] { code = sweep(request); });
}

void add_collect(CLI::App& program, std::filesystem::path& folder, std::vector<std::string>& series,
                 const std::string& typed) {
  auto* command = program.add_subcommand("collect", "gather a sweep's results into sweep.nc and sweep.csv");
  command->add_option("folder", folder, "folder of the sweep")->required()->type_name("DIR");
  command->add_option("--series", series, "the whole course of a number, by its name in run.nc; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->callback([&] { collect(folder, series, typed); });
}

void add_scene(CLI::App& command, RunRequest& request, std::string& preset) {
  command.add_option("scene", request.scene_file, "scene file (TOML)")->required()->type_name("SCENE.toml");
  add_overrides(command, request.overrides);
  command.add_option("--preset", preset, "accuracy for time: draft, standard or fine, see talus explain presets")
      ->type_name("NAME")
      ->check(CLI::IsMember(preset_names()));
}

void apply_preset(const std::string& preset, RunRequest& request) {
  if (!preset.empty()) request.overrides = with_preset(request.scene_file, preset, request.overrides);
}

int act(int argc, const char* const* argv) {
  CLI::App program("Talus: dense granular flow, from a scene file to a netCDF file.");
  program.require_subcommand(1);
  program.set_version_flag("--version", version_text());
  program.footer(
      "Exit codes: 0 done, 1 internal error, 2 command line or scene, 3 output folder, 4 cannot be continued,\n"
      "5 writing failed or disk full, 6 solver, 7 folder in use, 8 memory, 9 members of a sweep failed,\n"
      "75 stopped by SIGINT, SIGTERM or its wall limit: `talus restart`, for a sweep the same command, goes on.\n"
      "SIGUSR1 asks for a checkpoint.");

  int code = 0;
  RunRequest request;
  request.command = joined(argc, argv);
  std::filesystem::path out;
  auto* run_command = program.add_subcommand("run", "integrate a scene");
  std::string preset;
  add_scene(*run_command, request, preset);
  auto* out_option = run_command->add_option("--out", out, "output folder; default out/<scene.name>")->type_name("DIR");
  run_command->add_flag("--force", request.force, "replace an earlier run in that folder");
  run_command->callback([&] {
    if (*out_option) request.out = out;
    apply_preset(preset, request);
    code = run(request);
  });

  RestartRequest again;
  again.command = request.command;
  auto* restart_command = program.add_subcommand("restart", "go on with the run in a folder, from its last checkpoint");
  restart_command->add_option("folder", again.folder, "output folder of the run")->required()->type_name("DIR");
  add_overrides(*restart_command, again.overrides);
  restart_command->add_option("--allow", again.allowed, "let a key differ from the checkpoint; may be repeated")
      ->type_name("KEY")
      ->allow_extra_args(false);
  restart_command->callback([&] { code = restart(again); });

  auto* check_command = program.add_subcommand("check", "validate a scene; say what it costs and what theory expects");
  add_scene(*check_command, request, preset);
  check_command->callback([&] {
    apply_preset(preset, request);
    print(check_report(read_scene(request.scene_file, request.overrides)));
  });

  SweepRequest sweep_request;
  add_sweep(program, sweep_request, code);
  std::filesystem::path sweep_folder;
  std::vector<std::string> series;
  add_collect(program, sweep_folder, series, request.command);
  std::size_t member = 0;
  auto* member_command = program.add_subcommand("member", "run one member of a sweep's folder, for scripts");
  member_command->add_option("folder", sweep_folder, "folder of the sweep")->required()->type_name("DIR");
  member_command->add_option("number", member, "of the member, from 0")->required()->type_name("N");
  member_command->callback([&] { code = run_member(sweep_folder, member, request.command); });

  std::string section;
  auto* explain_command = program.add_subcommand("explain", "describe the keys of a scene file");
  explain_command->add_option(
      "section", section,
      "one section only, for example grid; sweep, axis and sample are a sweep file's, fit, unknown, "
      "slopes, profile, stage_2, shape and series a fit file's; presets tells those of run");
  explain_command->callback([&] { print(explanation(section)); });

  add_steady_command(program, request.command);
  add_study_command(program, request.command, code);
  add_fit_command(program, request.command);

  program.add_subcommand("list", "models and example scenes")->callback([] { print(list()); });

  add_rheology(program);
  add_hstop(program);

  std::filesystem::path folder;
  auto* plot_command = program.add_subcommand("plot", "draw the pictures of a run, or of a fit, into its folder");
  plot_command->add_option("folder", folder, "output folder of a run or a fit")->required()->type_name("DIR");
  bool movie = false;
  plot_command->add_flag("--movie", movie, "a movie of the whole event, too");
  plot_command->callback([&] { code = plot(folder, movie); });

  auto* report_command = program.add_subcommand(
      "report", "one HTML page of a run: what was run, verdicts, figures, an animation, statistics, provenance");
  report_command->add_option("folder", folder, "output folder of a run")->required()->type_name("DIR");
  std::optional<std::filesystem::path> page;
  report_command->add_option("--out", page, "the page; default report.html in that folder")->type_name("FILE.html");
  report_command->callback([&] { code = report(folder, page); });

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : static_cast<int>(core::ExitCode::configuration);
  }
  return code;
}

/// A closed standard stream would make the next file opened take its number, and messages would go into run.nc.
void keep_standard_streams() {
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = open("/dev/null", O_RDWR);
  if (file > STDERR_FILENO) close(file);
}

}  // namespace

int command_line(int argc, const char* const* argv) noexcept {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is then an error of the write, not a death
  std::signal(SIGPIPE, SIG_IGN);  // a run goes on when nobody listens to it any more
  keep_standard_streams();
  try {
    return act(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talus: %s\n", words_of(error).c_str());
    return exit_code_of(error);
  }
}

}  // namespace talus::app
