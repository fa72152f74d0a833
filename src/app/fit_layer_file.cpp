#include "app/fit_layer_file.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "app/fit_layer_data.hpp"
#include "app/material.hpp"
#include "app/parameter_names.hpp"
#include "app/scene.hpp"
#include "app/table.hpp"
#include "config/read.hpp"

namespace talus::app {
namespace {

using config::Problems;
using config::Values;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

class Reader {
 public:
  Reader(const Values& values, std::filesystem::path folder, FitFile& out, Problems& problems)
      : values_(values), folder_(std::move(folder)), out_(out), problems_(problems) {}

  void read(const std::vector<const Values*>& own) {
    FitLayer layer{folder_ / values_.text("stage_2.scene"), values_.texts("stage_2.set"), {}, {}};
    const Scene scene = read_scene(layer.scene, layer.settings);
    layer.stage.evaluations = static_cast<int>(values_.integer("stage_2.evaluations"));
    layer.stage.step = values_.number("stage_2.step");
    for (const auto& u : out_.problem.unknowns) layer.keys.push_back(scene_key(u.parameter));
    const auto known = config::read(scene_schema(), layer.scene, layer.settings);
    for (const auto* table : own) read_unknown(*table, known, layer);
    check_material(known, layer);
    read_layer_data(values_, folder_, layer.scene, scene, layer.stage, problems_);
    if (values_.tables("shape").empty() && values_.tables("series").empty())
      problems_.add(values_.place("stage_2.scene"), "stage_2", "no data for it; expected [[shape]] or [[series]]");
    if (out_.problem.condition != fit::Condition::report)
      problems_.add(values_.place("fit.condition"), "fit.condition",
                    "expected \"report\" with [stage_2], which keeps no condition but reports the margins");
    out_.layer = std::move(layer);
  }

 private:
  void read_unknown(const Values& table, const Values& known, FitLayer& layer) {
    const auto& name = table.text("unknown.parameter");
    const auto* key = scene_schema().find(name);
    const auto refuse = [&](const char* which, const std::string& what) {
      problems_.add(table.place(which), which, name + ": " + what);
    };
    if (key == nullptr || key->type != config::Type::number)
      return refuse("unknown.parameter", "is no number of a scene" + scene_schema().suggest_key(name));
    if (std::ranges::find(layer.keys, name) != layer.keys.end()) return refuse("unknown.parameter", "is unknown twice");
    fit::LayerUnknown unknown{name, key->unit, none, table.number("unknown.low"), table.number("unknown.high"), {}};
    const std::array<std::pair<const char*, double>, 2> bounds{
        {{"unknown.low", unknown.low}, {"unknown.high", unknown.high}}};
    for (const auto& [which, value] : bounds)
      if (const auto complaint = key->complaint(value)) refuse(which, *complaint);
    if (!(unknown.low < unknown.high))
      return refuse("unknown.high", "expected above unknown.low = " + shortest(unknown.low) + " [" + key->unit + "]");
    if (table.has("unknown.start")) unknown.start = table.number("unknown.start");
    else if (known.has(name)) unknown.start = known.number(name);
    else return refuse("unknown.parameter", "the scene states no value; expected unknown.start [" + key->unit + "]");
    if (!(unknown.start >= unknown.low && unknown.start <= unknown.high))
      return refuse(table.has("unknown.start") ? "unknown.start" : "unknown.low",
                    "the start " + shortest(unknown.start) + (table.has("unknown.start") ? "" : ", the scene's,") +
                        " is not between " + shortest(unknown.low) + " and " + shortest(unknown.high) + " [" +
                        key->unit + "]");
    if (table.has("unknown.prior"))
      unknown.prior = {table.number("unknown.prior"), table.number("unknown.prior_error")};
    layer.keys.push_back(name);
    layer.stage.unknowns.push_back(std::move(unknown));
  }

  /// What is known must be the same in both stages.
  void check_material(const Values& known, const FitLayer& layer) {
    if (known.has("schedule.gap") && std::ranges::find(layer.keys, "box.gap") != layer.keys.end())
      problems_.add(values_.place("stage_2.scene"), "schedule.gap",
                    "the gap of the scene changes in time: W cannot be unknown");
    const auto here = named_parameters(out_.problem.varied.channel);
    const auto there = named_parameters(read_material(layer.scene, layer.settings));
    const auto differ = [&](const std::string& what) {
      problems_.add(values_.place("stage_2.scene"), "stage_2.scene", "expected the material of fit.material; " + what);
    };
    for (const auto& [name, value] : here) {
      const auto other = std::ranges::find(there, name, &NamedNumbers::value_type::first);
      if (other == there.end()) return differ("its law has no " + name);
      if (other->second != value && !is_unknown(name))
        differ(name + " is " + shortest(other->second) + " there and " + shortest(value) + " here");
    }
    if (there.size() != here.size()) differ("its law is another");
  }

  /// Whether a known number may differ, as it is sought or follows from what is.
  [[nodiscard]] bool is_unknown(const std::string& name) const {
    if (name == "A") return true;
    return std::ranges::any_of(out_.problem.unknowns, [&](const auto& u) {
      const std::string key = scene_key(u.parameter), word = key.substr(key.find('.') + 1);
      return name == word || name.starts_with(word + "_m") || name.starts_with(word + "_kg");
    });
  }

  const Values& values_;
  std::filesystem::path folder_;
  FitFile& out_;
  Problems& problems_;
};

}  // namespace

void add_layer_keys(config::Schema& s) {
  using namespace config;  // NOLINT(google-build-using-namespace): a list of declarations
  s.section("stage_2",
            "the layer model beside the steady flow: unknowns also fit heap shapes and series, by runs of a scene");
  s.add(text("scene", "of the layer model, found from the folder of the fit file; its material is fit.material's")
            .optional("no second stage"));
  s.add(texts("set", "\"key=value\" for the scene, as talus run --set").fallback(std::vector<std::string>{}));
  s.add(integer("evaluations", "runs of the scene, at most; an iteration takes one and one more an unknown")
            .at_least(3)
            .at_most(100000)
            .fallback(std::int64_t{60}));
  s.add(number("step", "1", "of a difference that is taken for a derivative, as a share of the parameter's value")
            .above(0.0)
            .at_most(0.5)
            .fallback(0.02));
  s.repeated_section("shape", "heights of a heap at given times");
  s.add(text("file", "CSV with columns time_s, x_m, height_m, height_error_m; or a run.nc of Talus"));
  s.add(number("error", "m", "standard deviation of heights of a run.nc").above(0.0).optional("CSV has a column"));
  s.add(ascending_numbers("times", "s", "which records of a run.nc").at_least(0.0).optional("CSV: all rows"));
  s.repeated_section("series", "a number of the whole heap against time");
  s.add(text("file",
             "CSV with columns time_s and mass_kg, mass_error_kg or rate_kg_s, rate_error_kg_s or angle_deg, "
             "angle_error_deg; or a run.nc of Talus"));
  s.add(choice("quantity", series_quantities(), "which number, as run.nc calls it"));
  s.add(number("error", "", "standard deviation of a run.nc's numbers, in their unit")
            .above(0.0)
            .optional("CSV has a column"));
  s.add(ascending_numbers("times", "s", "which records of a run.nc").at_least(0.0).optional("all"));
}

std::string scene_key(steady::Parameter parameter) {
  using P = steady::Parameter;
  const std::string name(steady::parameter_names[static_cast<std::size_t>(parameter)]);
  switch (parameter) {
    case P::mu_w: return "wall.mu_w";
    case P::W: return "box.gap";
    case P::d:
    case P::Phi:
    case P::rho_star: return "grains." + name;
    default: return "rheology." + name;
  }
}

void read_layer(const Values& values, const std::filesystem::path& folder, const std::vector<const Values*>& own,
                FitFile& out, Problems& problems) {
  if (values.has("stage_2.scene")) return Reader(values, folder, out, problems).read(own);
  const auto refuse = [&](const Values& table, const char* key) {
    problems.add(table.place(key), key, "is for the layer model; expected [stage_2] with its scene");
  };
  for (const auto& table : values.tables("shape")) refuse(table, "shape.file");
  for (const auto& table : values.tables("series")) refuse(table, "series.file");
  for (const auto* table : own) refuse(*table, "unknown.parameter");
}

}  // namespace talus::app
