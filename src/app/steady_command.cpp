#include "app/steady_command.hpp"

#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "app/material.hpp"
#include "app/number_list.hpp"
#include "app/steady_cases.hpp"
#include "app/steady_file.hpp"
#include "app/steady_json.hpp"
#include "app/steady_table.hpp"
#include "core/errors.hpp"

namespace talus::app {
namespace {

struct Request {
  std::filesystem::path file, out;
  std::vector<std::string> overrides;
  std::string law;
  std::optional<std::string> zeta, flux, speed;
  double thickness = steady::unbounded;
  int points = 0;
  bool json = false;
  std::string command;
};

steady::Channel channel_of(const Request& request) {
  auto overrides = request.overrides;
  if (!request.law.empty()) {
    const std::string word = request.law == "partial" ? "partially_regularised" : request.law;
    overrides.push_back("rheology.law=" + word);
  }
  return read_material(request.file, overrides);
}

struct Values {
  SteadyGiven given;
  std::vector<double> values;
};

Values values_of(const Request& request) {
  std::vector<Values> lists;
  const auto add = [&](SteadyGiven given, const std::optional<std::string>& text, const char* option,
                       const char* unit) {
    if (text) lists.push_back({given, number_list(*text, option, unit)});
  };
  add(SteadyGiven::zeta, request.zeta, "--zeta", "degree");
  add(SteadyGiven::flux, request.flux, "--Q", "kg/s");
  add(SteadyGiven::mean_speed, request.speed, "--depth-averaged-speed", "m/s");
  if (lists.size() != 1)
    throw core::ConfigError("steady: expected one of --zeta, --Q and --depth-averaged-speed, found " +
                            std::to_string(lists.size()));
  return lists.front();
}

void act(const Request& request) {
  constexpr int default_points = 101;
  const auto [given, values] = values_of(request);
  const auto channel = channel_of(request);
  const auto study = [&] {
    try {
      return solve_steady(channel, request.thickness, given, values,
                          request.points > 0 ? request.points : default_points);
    } catch (const std::invalid_argument& error) {
      throw core::ConfigError(request.file.string() + ": " + error.what());
    } catch (const std::domain_error& error) {  // of a search for a root
      throw core::Error(core::ExitCode::solver, std::string("steady: ") + error.what());
    }
  }();
  const bool profiles = request.points > 0;
  const std::string text = request.json ? steady_json(study, profiles) : steady_table(study, profiles);
  if (!request.out.empty()) write_steady_file(request.out, study, request.command);
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_steady_command(CLI::App& program, const std::string& command) {
  const auto request = std::make_shared<Request>();
  request->command = command;
  auto* steady = program.add_subcommand("steady", "exact steady uniform flow: slope, flow rate, profiles, depths");
  steady->add_option("file", request->file, "scene or material file (TOML)")->required()->type_name("FILE.toml");
  steady->add_option("--zeta", request->zeta, "slopes [degree]: numbers and ranges, 30,45 or 30:50:5")
      ->type_name("LIST");
  steady->add_option("--Q", request->flux, "mass flows [kg/s], for example 1e-4:1e-2:x21")->type_name("LIST");
  steady
      ->add_option("--depth-averaged-speed", request->speed,
                   "[m/s]; over the depth to the base, or to 1 % of the surface speed")
      ->type_name("LIST");
  steady->add_option("--law", request->law, "friction law instead of the file's")
      ->check(CLI::IsMember({"classical", "partial", "partially_regularised", "constant"}));
  steady->add_option("--thickness", request->thickness, "of a layer over a no-slip base [m]; default: a heap, no base")
      ->check(CLI::PositiveNumber);
  steady
      ->add_option("--points", request->points,
                   "points of each profile, in JSON and table too; in a file 101 without it")
      ->check(CLI::Range(2, 1000000));
  steady->add_option("--set", request->overrides, "replace a value of the file; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  steady->add_flag("--json", request->json, "JSON instead of a table");
  steady->add_option("--out", request->out, "profiles as a netCDF file, too; replaced if it exists")
      ->type_name("FILE.nc");
  steady->footer(
      "Examples:\n"
      "  talus steady runs/examples/heap_q46.toml --Q 0.002,0.0046,0.006\n"
      "  talus steady runs/examples/heap_q46.toml --law classical --zeta 22:42:1 --json\n"
      "  talus steady runs/examples/heap_q46.toml --zeta 25 --set wall.mu_w=0 --thickness 0.02 --points 201 --out "
      "layer.nc\n"
      "Where no steady flow exists the answer says why, and the exit code is 0.");
  steady->callback([request] { act(*request); });
}

}  // namespace talus::app
