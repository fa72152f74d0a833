#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include "app/check.hpp"
#include "app/exit_code.hpp"
#include "app/list.hpp"
#include "app/plot.hpp"
#include "app/rheology.hpp"
#include "app/run.hpp"
#include "app/scene.hpp"
#include "app/versions.hpp"

namespace talus::app {
namespace {

void print(const std::string& text) { std::fputs(text.c_str(), stdout); }

std::string joined(int argc, const char* const* argv) {
  std::string command;
  for (int i = 0; i < argc; ++i) command += (i > 0 ? " " : "") + std::string(argv[i]);
  return command;
}

void add_scene(CLI::App& command, RunRequest& request) {
  command.add_option("scene", request.scene_file, "scene file (TOML)")->required()->type_name("SCENE.toml");
  command.add_option("--set", request.overrides, "replace a value of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

int act(int argc, const char* const* argv) {
  CLI::App program("Talus: dense granular flow, from a scene file to a netCDF file.");
  program.require_subcommand(1);
  program.set_version_flag("--version", version_text());
  program.footer(
      "Exit codes: 0 done, 1 internal error, 2 command line or scene, 3 output folder, 5 writing failed, 6 solver,\n"
      "7 folder in use, 8 memory, 128 + signal stopped by SIGINT or SIGTERM.");

  int code = 0;
  RunRequest request;
  request.command = joined(argc, argv);
  std::filesystem::path out;
  auto* run_command = program.add_subcommand("run", "integrate a scene");
  add_scene(*run_command, request);
  auto* out_option = run_command->add_option("--out", out, "output folder; default out/<scene.name>")->type_name("DIR");
  run_command->add_flag("--force", request.force, "replace an earlier run in that folder");
  run_command->callback([&] {
    if (*out_option) request.out = out;
    code = run(request);
  });

  auto* check_command = program.add_subcommand("check", "validate a scene; say what it costs and what theory expects");
  add_scene(*check_command, request);
  check_command->callback([&] { print(check_report(read_scene(request.scene_file, request.overrides))); });

  std::string section;
  auto* explain_command = program.add_subcommand("explain", "describe the keys of a scene file");
  explain_command->add_option("section", section, "one section only, for example grid");
  explain_command->callback([&] { print(config::explain(scene_schema(), section)); });

  program.add_subcommand("list", "models and example scenes")->callback([] { print(list()); });

  add_rheology(program);

  std::filesystem::path folder;
  auto* plot_command = program.add_subcommand("plot", "draw the pictures of a run into its folder");
  plot_command->add_option("folder", folder, "output folder of a run")->required()->type_name("DIR");
  bool movie = false;
  plot_command->add_flag("--movie", movie, "a movie of the whole event, too");
  plot_command->callback([&] { code = plot(folder, movie); });

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : static_cast<int>(core::ExitCode::configuration);
  }
  return code;
}

}  // namespace

int command_line(int argc, const char* const* argv) noexcept {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is then an error of the write, not a death
  try {
    return act(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "talus: %s\n", error.what());
    return exit_code_of(error);
  }
}

}  // namespace talus::app
