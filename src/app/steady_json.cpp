#include "app/steady_json.hpp"

#include <nlohmann/json.hpp>
#include <numbers>

#include "app/parameter_names.hpp"
#include "app/rheology_report.hpp"
#include "app/steady_quantities.hpp"
#include "app/table.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double degree = std::numbers::pi / 180.0;

Json number(double value) { return json_of(value); }
Json number(const std::optional<double>& value) { return value ? json_of(*value) : Json(nullptr); }
Json degrees(const std::optional<double>& radians) { return radians ? number(*radians / degree) : Json(nullptr); }

const char* key_of(SteadyGiven given) {
  switch (given) {
    case SteadyGiven::zeta: return "zeta_deg";
    case SteadyGiven::flux: return "Q_kg_s";
    default: return "depth_averaged_speed_m_s";
  }
}

Json ranges(const std::vector<steady::DepthRange>& all) {
  Json out = Json::array();
  for (const auto& [from, to] : all) out.push_back({number(from), number(to)});
  return out;
}

/// Depth below which the last range reaches the end of the flow.
Json below(const std::vector<steady::DepthRange>& all, double end) {
  return !all.empty() && all.back().to == end ? number(all.back().from) : Json(nullptr);
}

bool at_surface(const std::vector<steady::DepthRange>& all) { return !all.empty() && all.front().from == 0.0; }

Json profiles_of(const SteadyFlow& s) {
  Json out;
  for (const auto& profile : steady_profiles()) {
    Json values = Json::array();
    for (std::size_t i = 0; i < s.depths.size(); ++i) values.push_back(number(profile.value(s, i)));
    out[std::string(profile.name) + profile.suffix] = std::move(values);
  }
  return out;
}

/// All keys of a flow; null, every one, where there is none.
Json answer(const std::optional<SteadyFlow>& s, bool profiles) {
  Json out;
  const auto put = [&](const std::string& key, auto&& value) { out[key] = s ? Json(value(*s)) : Json(nullptr); };
  for (const auto& quantity : steady_quantities())
    put(std::string(quantity.name) + quantity.suffix,
        [&](const SteadyFlow& flow) { return number(quantity.value(flow)); });
  put("ends_on_base", [](const SteadyFlow& f) { return f.flow.on_base(); });
  put("averaged_over", [](const SteadyFlow& f) { return f.mean.to_base ? "base" : "depth_1_percent"; });
  put("C_inside_at_surface", [](const SteadyFlow& f) { return !at_surface(f.posed.C_positive); });
  put("C_inside_everywhere", [](const SteadyFlow& f) { return f.posed.C_positive.empty(); });
  put("C_positive_depths_m", [](const SteadyFlow& f) { return ranges(f.posed.C_positive); });
  put("C_positive_below_m", [](const SteadyFlow& f) { return below(f.posed.C_positive, f.flow.depth()); });
  put("q_inside_at_surface", [](const SteadyFlow& f) { return !at_surface(f.posed.q_beyond); });
  put("q_inside_everywhere", [](const SteadyFlow& f) { return f.posed.q_beyond.empty(); });
  put("q_beyond_depths_m", [](const SteadyFlow& f) { return ranges(f.posed.q_beyond); });
  if (profiles) put("profile", profiles_of);
  return out;
}

}  // namespace

std::string steady_json(const SteadyStudy& study, bool profiles) {
  Json parameters;
  for (const auto& [name, value] : named_parameters(study.channel)) parameters[name] = number(value);
  Json out{{"talus_version", output::version()},
           {"git_revision", output::git_revision()},
           {"law", law_word(study.channel.law)},
           {"parameters", parameters},
           {"thickness_m", number(study.thickness)},
           {"neutral_points_I", study.bounds.neutral},
           {"q_is_one_I", study.bounds.q_is_one},
           {"Q_max_kg_s", number(study.maximal_flux)},
           {"Q_max_classical_kg_s", number(study.maximal_classical_flux)},
           {"zeta_max_deg", degrees(study.steepest)},
           {"given", key_of(study.given)}};
  Json cases = Json::array();
  for (const SteadyCase& each : study.cases) {
    Json one{{"given", number(each.given)},
             {"exists", each.flow.has_value()},
             {"reason", each.flow ? Json(nullptr) : Json(each.reason)}};
    one.update(answer(each.flow, profiles));
    if (!each.flow) one[key_of(study.given)] = number(each.given);
    cases.push_back(std::move(one));
  }
  out["cases"] = std::move(cases);
  return out.dump(2) + "\n";
}

}  // namespace talus::app
