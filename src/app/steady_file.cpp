#include "app/steady_file.hpp"

#include <limits>

#include "app/parameter_names.hpp"
#include "app/rheology_report.hpp"
#include "app/steady_quantities.hpp"
#include "app/versions.hpp"
#include "output/provenance.hpp"
#include "output/table_file.hpp"

namespace talus::app {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

output::Attributes attributes_of(const SteadyStudy& study, const std::string& command) {
  auto out = output::provenance_attributes({.scene_text = "", .command = command, .libraries = library_versions()});
  out["Conventions"] = "CF-1.8";
  out["title"] = "Exact steady uniform flow";
  out["law"] = law_word(study.channel.law);
  for (const auto& [name, value] : named_parameters(study.channel)) out[name] = value;
  if (study.thickness != steady::unbounded) out["thickness_m"] = study.thickness;
  return out;
}

output::TableVariable along_cases(const SteadyStudy& study, const SteadyQuantity& quantity) {
  std::vector<double> values;
  for (const auto& each : study.cases) values.push_back(each.flow ? quantity.value(*each.flow) : missing);
  return {quantity.name, {"case"}, quantity.unit, quantity.long_name, values};
}

output::TableVariable along_depth(const SteadyStudy& study, const SteadyProfile& profile) {
  std::vector<double> values;
  for (const auto& each : study.cases)
    for (std::size_t i = 0; i < study.points; ++i) values.push_back(each.flow ? profile.value(*each.flow, i) : missing);
  output::TableVariable variable{profile.name, {"case", "point"}, profile.unit, profile.long_name, values};
  const bool is_depth = profile.name == std::string("depth");
  variable.attributes[is_depth ? "positive" : "coordinates"] = is_depth ? "down" : "zeta depth";
  return variable;
}

}  // namespace

void write_steady_file(const std::filesystem::path& path, const SteadyStudy& study, const std::string& command) {
  output::Table table{.dimensions = {{"case", study.cases.size()}, {"point", study.points}},
                      .variables = {},
                      .attributes = attributes_of(study, command)};
  for (const auto& quantity : steady_quantities()) table.variables.push_back(along_cases(study, quantity));
  for (const auto& profile : steady_profiles()) table.variables.push_back(along_depth(study, profile));
  std::vector<std::string> reasons;
  for (const auto& each : study.cases) reasons.push_back(each.reason);
  table.variables.push_back({"reason", {"case"}, "", "why there is no steady flow; empty where there is one", reasons});
  output::write_table(path, table);
}

}  // namespace talus::app
