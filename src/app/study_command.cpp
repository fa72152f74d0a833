#include "app/study_command.hpp"

#include <memory>

#include "app/study_converge.hpp"
#include "app/study_trade.hpp"
#include "app/study_wellposed.hpp"

namespace talus::app {
namespace {

void add_scene(CLI::App& command, std::filesystem::path& file, std::vector<std::string>& overrides) {
  command.add_option("scene", file, "scene file (TOML)")->required()->type_name("SCENE.toml");
  command.add_option("--set", overrides, "replace a value of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_converge(CLI::App& study, const std::string& typed, int& code) {
  constexpr int most_levels = 8;
  const auto request = std::make_shared<ConvergeRequest>();
  request->command = typed;
  auto* command =
      study.add_subcommand("converge", "the scene on refined grids: observed orders, limits, uncertainties");
  add_scene(*command, request->scene_file, request->overrides);
  command->add_option("--levels", request->levels, "grids: the scene's own and its refinements by 2; default 4")
      ->type_name("N")
      ->check(CLI::Range(2, most_levels));
  command
      ->add_option("--in", request->directions,
                   "what is refined: x columns, z layers, t tolerances (by 4); default the grid")
      ->type_name("x,z,t");
  command->add_option("--jobs", request->jobs, "levels at a time; default one on each core")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  command->add_option("--out", request->out, "folder of the study; default out/<scene.name>_converge")
      ->type_name("DIR");
  command->add_flag("--force", request->force, "run levels again whose scene has changed");
  command->footer(
      "Leaves study.nc, verdict.json and study.png beside the runs. Interrupted, the same command goes on; with more\n"
      "--levels only the new ones are run. The exit code is 0 whatever the verdict.");
  command->callback([request, &code] { code = study_converge(*request); });
}

void add_wellposed(CLI::App& study, const std::string& typed, int& code) {
  const auto request = std::make_shared<WellposedRequest>();
  request->command = typed;
  auto* command =
      study.add_subcommand("wellposed", "is the scene's model well-posed on grids, and is its steady state stable?");
  add_scene(*command, request->scene_file, request->overrides);
  command
      ->add_option(
          "--parts", request->parts,
          "symbol: growth of plane waves in uniform shear over I and grids; modes: of the discrete steady state; "
          "time: disturbances of a uniform layer on refined grids; default the first two")
      ->delimiter(',')
      ->check(CLI::IsMember({"symbol", "modes", "time"}));
  command->add_option("--I", request->I, "inertial numbers of the symbol; default 1e-6:1e4:x41")->type_name("LIST");
  command->add_option("--cells", request->most_cells,
                      "cells a side of the symbol's finest grid, a power of 2; default 1024");
  command->add_option("--waves", request->waves, "wavelengths of a uniform layer's modes; default 32")
      ->check(CLI::Range(2, 1000));
  command->add_option("--levels", request->levels, "grids in time: the scene's own and its refinements by 2; default 4")
      ->type_name("N")
      ->check(CLI::Range(2, 8));
  command
      ->add_option("--single", request->single,
                   "in time, besides noise: waves disturbed alone, whole ones over the box; default 1 and a quarter of "
                   "the columns")
      ->type_name("M,...")
      ->delimiter(',');
  command->add_option("--jobs", request->jobs, "runs at a time; default one on each core")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  command->add_option("--out", request->out, "folder of the study; default out/<scene.name>_wellposed")
      ->type_name("DIR");
  command->add_flag("--force", request->force, "run again what was run of another scene");
  command->footer(
      "A periodic scene's steady state is a uniform layer, whose modes are plane waves; another's is sought from the "
      "end of its inflow.\n"
      "Leaves study.nc, verdict.json and study.png. The exit code is 0 whatever the verdict.");
  command->callback([request, &code] { code = study_wellposed(*request); });
}

void add_trade(CLI::App& study, const std::string& typed, int& code) {
  const auto request = std::make_shared<TradeRequest>();
  request->command = typed;
  auto* command = study.add_subcommand(
      "trade", "what accuracy costs: the scene by many choices of grid, tolerances, solvers, rung");
  add_scene(*command, request->scene_file, request->overrides);
  command
      ->add_option("--by", request->by,
                   "number of the model by which choices are judged; default heap_angle, mass_flow or mass_stored")
      ->type_name("NAME");
  command->add_option("--jobs", request->jobs, "choices at a time; default 1, since neighbours make CPU time dearer")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  command->add_option("--out", request->out, "folder of the study; default out/<scene.name>_trade")->type_name("DIR");
  command->add_flag("--force", request->force, "run choices again whose scene has changed");
  command->footer(
      "The scene as it stands, a reference with cells halved and a tenth of rtol, and the scene with one thing changed "
      "at a time; errors are\n"
      "against the reference, and of a heap's slope against the exact one. Leaves study.nc, trade.csv, verdict.json "
      "and study.png\n"
      "beside the runs. Interrupted, the same command goes on. Choices that fail are rows of the table.");
  command->callback([request, &code] { code = study_trade(*request); });
}

}  // namespace

void add_study_command(CLI::App& program, const std::string& command, int& code) {
  auto* study = program.add_subcommand("study", "many runs of a scene that answer one question");
  study->require_subcommand(1);
  add_converge(*study, command, code);
  add_trade(*study, command, code);
  add_wellposed(*study, command, code);
}

}  // namespace talus::app
