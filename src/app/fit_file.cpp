#include "app/fit_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/fit_layer_file.hpp"
#include "app/material.hpp"
#include "app/measured_columns.hpp"
#include "app/table.hpp"
#include "config/name.hpp"
#include "config/number_csv.hpp"
#include "config/problems.hpp"
#include "config/read.hpp"
#include "config/spelling.hpp"

namespace talus::app {
namespace {

using config::Problems;
using config::Values;

constexpr double degree = std::numbers::pi / 180.0, any = 1e300;

const std::vector<std::string> parameter_words{steady::parameter_names.begin(), steady::parameter_names.end()};
/// Of a profile in a netCDF file: keys that name its variables.
const std::vector<const char*> variable_keys{"profile.depth", "profile.speed", "profile.speed_error"};

/// Rows of a data file named by `key`, at least `least` of them.
std::vector<std::vector<double>> rows_of(const Values& table, const char* key, const std::filesystem::path& folder,
                                         const std::vector<config::CsvColumn>& columns, std::size_t least,
                                         Problems& problems, const std::vector<std::string>& variables = {}) {
  const auto path = folder / table.text(key);
  auto read = variables.empty() ? config::read_csv(path, columns) : read_columns(path, columns, variables);
  if (read[0].size() < least)
    problems.add(table.place(key), key,
                 path.string() + ": expected at least " + std::to_string(least) + " rows of data, found " +
                     std::to_string(read[0].size()));
  return read;
}

void read_slopes(const Values& table, const std::filesystem::path& folder, const std::vector<double>& hold_back,
                 FitFile& out, Problems& problems) {
  static const std::vector<config::CsvColumn> columns{
      {"Q_kg_s", "kg/s", "mass flow", 0.0, any},
      {"Q_error_kg_s", "kg/s", "its standard deviation", 0.0, any, true},
      {"zeta_deg", "degree", "slope of the face", 0.0, 90.0},
      {"zeta_error_deg", "degree", "its standard deviation", 0.0, any}};
  const auto read = rows_of(table, "slopes.file", folder, columns, 1, problems);
  for (std::size_t i = 0; i < read[0].size(); ++i) {
    const fit::SlopePoint point{read[0][i], read[1][i], read[2][i] * degree, read[3][i] * degree,
                                table.text("slopes.file") + " row " + std::to_string(i + 1)};
    const bool held = std::ranges::any_of(hold_back, [&](double Q) { return std::abs(point.Q - Q) <= 1e-9 * Q; });
    (held ? out.held_back : out.problem.slopes).push_back(point);
  }
}

void read_profile(const Values& table, const std::filesystem::path& folder, const std::vector<double>& hold_back,
                  FitFile& out, Problems& problems) {
  static const std::vector<config::CsvColumn> columns{{"depth_m", "m", "below the surface, normal to it", -any, any},
                                                      {"speed_m_s", "m/s", "along the surface", -any, any},
                                                      {"speed_error_m_s", "m/s", "its standard deviation", 0.0, any}};
  if (table.has("profile.flow") == table.has("profile.slope"))
    problems.add(table.place("profile.file"), "profile.flow",
                 "expected one of profile.flow [kg/s] and profile.slope [degree]");
  std::vector<std::string> variables;
  for (const char* key : variable_keys) {
    const bool given = table.has(key);
    variables.push_back(given ? table.text(key) : std::string(key).substr(std::string("profile.").size()));
    if (given && !is_netcdf(table.text("profile.file")))
      problems.add(table.place(key), key, "is for netCDF files (.nc); the columns of a CSV file have fixed names");
  }
  const auto read = rows_of(table, "profile.file", folder, columns, 3, problems, variables);
  fit::SpeedProfile profile{table.text("profile.file"),          {}, {}, read[0], read[1], read[2],
                            table.number("profile.offset_limit")};
  if (table.has("profile.flow")) profile.Q = table.number("profile.flow");
  if (table.has("profile.slope")) profile.zeta = table.number("profile.slope") * degree;
  const bool held =
      profile.Q && std::ranges::any_of(hold_back, [&](double Q) { return std::abs(*profile.Q - Q) <= 1e-9 * Q; });
  if (!held) out.problem.profiles.push_back(std::move(profile));
}

std::string expected_parameter(const std::string& name) {
  std::string words;
  for (const auto& word : parameter_words) words += (words.empty() ? "" : ", ") + word;
  const auto guess = config::nearest(name, parameter_words);
  return "expected one of " + words + ", or a key of the scene of [stage_2]" +
         (guess ? " (did you mean " + *guess + "?)" : "") + ", found \"" + name + "\"";
}

void read_unknown(const Values& table, const steady::Channel& channel, FitFile& out, Problems& problems) {
  const auto at =
      static_cast<int>(std::ranges::find(parameter_words, table.text("unknown.parameter")) - parameter_words.begin());
  const auto parameter = steady::Parameter{at};
  const std::string name(steady::parameter_names[static_cast<std::size_t>(at)]);
  const std::string unit(steady::parameter_units[static_cast<std::size_t>(at)]);
  const auto refuse = [&](const char* key, const std::string& what) { problems.add(table.place(key), key, what); };
  if (!steady::uses(channel.law, parameter))
    return refuse("unknown.parameter",
                  name + ": the " + std::string(rheology::name(channel.law)) + " law has no such parameter");
  for (const auto& other : out.problem.unknowns)
    if (other.parameter == parameter) refuse("unknown.parameter", name + ": is unknown twice");
  fit::Unknown unknown{
      parameter, steady::value_of(channel, parameter), table.number("unknown.low"), table.number("unknown.high"), {}};
  if (table.has("unknown.start")) unknown.start = table.number("unknown.start");
  if (!(unknown.low < unknown.high))
    refuse("unknown.high", name + ": expected above unknown.low = " + shortest(unknown.low) + " [" + unit + "]");
  if (parameter == steady::Parameter::Phi && unknown.high > 1.0) refuse("unknown.high", name + ": expected at most 1");
  if (!(unknown.start >= unknown.low && unknown.start <= unknown.high))
    refuse(table.has("unknown.start") ? "unknown.start" : "unknown.low",
           name + ": the start " + shortest(unknown.start) + (table.has("unknown.start") ? "" : ", the material's,") +
               " is not between " + shortest(unknown.low) + " and " + shortest(unknown.high) + " [" + unit + "]");
  if (table.has("unknown.prior")) unknown.prior = {table.number("unknown.prior"), table.number("unknown.prior_error")};
  out.problem.unknowns.push_back(unknown);
}

template <class Word>
Word meaning(const std::string& word, std::initializer_list<std::pair<const char*, Word>> all) {
  return std::ranges::find(all, word, [](const auto& each) { return std::string(each.first); })->second;
}

}  // namespace

const config::Schema& fit_schema() {
  using namespace config;  // NOLINT(google-build-using-namespace): a list of declarations
  static const Schema schema = [] {
    Schema s;
    s.section("fit", "what this is; a file of its own, for talus fit");
    s.add(text("name", "short name: letters, digits, - and _; the default folder is out/<name>"));
    s.add(text("title", "one line").fallback(std::string()));
    s.add(
        text("material", "scene or material file with all that is not unknown, found from the folder of the fit file"));
    s.add(texts("set", "\"key=value\" for the material, as talus run --set").fallback(std::vector<std::string>{}));
    s.add(choice("loss", {"square", "huber", "cauchy"}, "what a residual beyond loss_scale counts: its square, or less")
              .fallback(std::string("square")));
    s.add(number("loss_scale", "1", "in standard deviations").above(0.0).fallback(2.0));
    s.add(
        choice("condition", {"report", "C", "q"},
               "well-posedness at the surface of all flows measured: reported only, or kept as C <= 0 (3.18) or q <= 1")
            .fallback(std::string("report")));
    s.add(integer("starts", "from how many points the minimum is sought")
              .at_least(1)
              .at_most(1000)
              .fallback(std::int64_t{8}));
    s.add(numbers("hold_back", "kg/s", "flows whose data are left out, and predicted; also flows without data")
              .above(0.0)
              .fallback(std::vector<double>{}));
    s.repeated_section("unknown", "a parameter to be found");
    s.add(
        text("parameter",
             "one of mu_s, mu_d, mu_inf, I_0, alpha, mu_w, W [m], d [m], Phi, rho_star [kg/m3]; with [stage_2] also a "
             "number of its scene by its key, as box.base_friction, in its unit"));
    s.add(number("low", "", "least value, in the parameter's unit").above(0.0));
    s.add(number("high", "", "largest value").above(0.0));
    s.add(number("start", "", "where the search begins")
              .above(0.0)
              .optional("the value of the material, or of the scene"));
    s.add(number("prior", "", "value known before").optional("none"));
    s.add(number("prior_error", "", "its standard deviation").above(0.0).optional("none"));
    s.repeated_section("slopes", "slopes of steady faces against mass flow");
    s.add(text("file", "CSV with columns Q_kg_s, Q_error_kg_s, zeta_deg, zeta_error_deg"));
    s.repeated_section("profile", "speeds along the normal to a steady face");
    s.add(
        text("file", "CSV with columns depth_m, speed_m_s, speed_error_m_s; or netCDF (.nc) with the variables below"));
    s.add(text("depth", "netCDF variable, units m").optional("depth"));
    s.add(text("speed", "netCDF variable, units m/s").optional("speed"));
    s.add(text("speed_error", "netCDF variable, units m/s").optional("speed_error"));
    s.add(number("flow", "kg/s", "mass flow under that face").above(0.0).optional("profile.slope instead"));
    s.add(number("slope", "degree", "its slope").above(0.0).below(90.0).optional("profile.flow instead"));
    s.add(number("offset_limit", "m", "how far the surface may lie above or below depth_m = 0; 0: exactly there")
              .at_least(0.0)
              .fallback(0.0));
    add_layer_keys(s);
    return s;
  }();
  return schema;
}

FitFile read_fit(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const auto v = config::read(fit_schema(), file, overrides);
  const auto folder = file.parent_path();
  const auto material = folder / v.text("fit.material");
  FitFile out{v.text("fit.name"), v.text("fit.title"), {{read_material(material, v.texts("fit.set"))}}, {}};
  auto& problem = out.problem;
  problem.varied.I_N_follows = std::holds_alternative<rheology::PartiallyRegularised>(problem.varied.channel.law) &&
                               !config::read(material_schema(), material, v.texts("fit.set")).has("rheology.I_N");
  problem.loss = meaning<fit::Loss>(
      v.text("fit.loss"), {{"square", fit::Loss::square}, {"huber", fit::Loss::huber}, {"cauchy", fit::Loss::cauchy}});
  problem.loss_scale = v.number("fit.loss_scale");
  problem.condition =
      meaning<fit::Condition>(v.text("fit.condition"),
                              {{"report", fit::Condition::report}, {"C", fit::Condition::C}, {"q", fit::Condition::q}});
  problem.starts = static_cast<int>(v.integer("fit.starts"));
  problem.predict = v.numbers("fit.hold_back");
  Problems problems;
  if (!config::is_plain_name(out.name))
    problems.add(v.place("fit.name"), "fit.name", std::string("expected ") + config::plain_name);
  const auto& channel = problem.varied.channel;
  if (std::holds_alternative<rheology::Constant>(channel.law))
    problems.add(v.place("fit.material"), "rheology.law",
                 "expected a law that grows with I: constant friction selects no speed");
  if (channel.mu_w == 0.0)
    problems.add(v.place("fit.material"), "wall.mu_w",
                 "expected above 0: without side walls a heap has no steady flow of its own slope");
  std::vector<const Values*> of_scene;
  for (const auto& table : v.tables("unknown")) {
    const auto& name = table.text("unknown.parameter");
    if (table.has("unknown.prior") != table.has("unknown.prior_error"))
      problems.add(table.place(table.has("unknown.prior") ? "unknown.prior" : "unknown.prior_error"), "unknown.prior",
                   name + ": expected unknown.prior and unknown.prior_error together");
    else if (std::ranges::find(parameter_words, name) != parameter_words.end())
      read_unknown(table, channel, out, problems);
    else if (name.find('.') != std::string::npos) of_scene.push_back(&table);
    else problems.add(table.place("unknown.parameter"), "unknown.parameter", expected_parameter(name));
  }
  if (v.tables("unknown").empty()) problems.add(v.place(""), "unknown", "missing; expected [[unknown]], at least one");
  for (const auto& table : v.tables("slopes")) read_slopes(table, folder, problem.predict, out, problems);
  for (const auto& table : v.tables("profile")) read_profile(table, folder, problem.predict, out, problems);
  read_layer(v, folder, of_scene, out, problems);
  if (problem.slopes.empty() && problem.profiles.empty() && !out.layer)
    problems.add(v.place(""), "slopes",
                 "no data to fit; expected [[slopes]] or [[profile]] with flows that are not held back");
  problems.throw_if_any();
  return out;
}

}  // namespace talus::app
