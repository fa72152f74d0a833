#include "app/rheology_report.hpp"

#include <array>
#include <cmath>

#include "app/parameter_names.hpp"
#include "app/table.hpp"
#include "app/words.hpp"
#include "rheology/neutral_points.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using rheology::Law;

template <class... Arguments>
std::string line(const char* pattern, Arguments... arguments) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), pattern, arguments...);
  return std::string(text.data()) + "\n";
}

Json range_json(const std::vector<rheology::Range>& ranges) {
  Json out = Json::array();
  for (const auto& range : ranges) out.push_back({json_of(range.from), json_of(range.to)});
  return out;
}

Json points_json(const std::vector<rheology::BranchPoint>& points) {
  Json out = Json::array();
  for (const auto& point : points)
    out.push_back({{"I", point.I},
                   {"branch", point.branch == rheology::Branch::rational ? "rational" : "creep"},
                   {"relevant", point.relevant}});
  return out;
}

std::string ranges_text(const std::vector<rheology::Range>& ranges) {
  std::string out;
  for (const auto& range : ranges) {
    std::array<char, 80> text{};
    if (std::isfinite(range.to)) std::snprintf(text.data(), text.size(), "%.10g to %.10g", range.from, range.to);
    else std::snprintf(text.data(), text.size(), "above %.10g", range.from);
    out += (out.empty() ? "" : ", ") + std::string(text.data());
  }
  return out.empty() ? "nowhere" : out;
}

std::string points_text(const char* what, const std::vector<rheology::BranchPoint>& points) {
  std::string out;
  for (const auto& point : points)
    out += line("%-17s I = %.15g%s", what, point.I,
                point.relevant ? ""
                : point.branch == rheology::Branch::rational
                    ? "   irrelevant: rational branch, creep rules there"
                    : "   irrelevant: creep branch, the rational one rules there");
  return out;
}

}  // namespace

std::string law_word(const Law& law) {
  static const auto names = words::of(words::laws);
  return names[law.index()];
}

Json rheology_summary(const Law& law) {
  Json out;
  for (const auto& [name, value] : named_parameters(law)) out["parameters"][name] = value;
  out["mu_at_rest"] = rheology::friction_at_rest(law);
  out["mu_bound"] = json_of(rheology::friction_bound(law));
  if (const auto* partial = std::get_if<rheology::PartiallyRegularised>(&law)) {
    out["mu_at_I_N"] = partial->mu_N;
    out["A"] = partial->A;
    out["slope_below_I_N"] = rheology::friction_slope(law, partial->I_N);
    out["slope_above_I_N"] = rheology::friction_slope(law, std::nextafter(partial->I_N, 1e300));
  }
  out["neutral_points"] = points_json(rheology::branch_neutral_points(law));
  out["ellipticity_bounds"] = points_json(rheology::branch_ellipticity_bounds(law));
  out["well_posed_by_C"] = range_json(rheology::ranges_of_condition(law));
  out["well_posed_by_linear_theory"] = range_json(rheology::ranges_of_damping(law));
  return out;
}

std::string rheology_text(const Law& law) {
  std::string out = line("law               %s", std::string(rheology::name(law)).c_str());
  const double bound = rheology::friction_bound(law);
  out += std::isfinite(bound)
             ? line("mu                from %.10g at rest towards %.10g", rheology::friction_at_rest(law), bound)
             : line("mu                from %.10g at rest without bound", rheology::friction_at_rest(law));
  if (const auto* partial = std::get_if<rheology::PartiallyRegularised>(&law)) {
    out += line("I_N               %.15g, mu(I_N) = %.15g", partial->I_N, partial->mu_N);
    out += line("slope at I_N      %.10g below, %.10g above", rheology::friction_slope(law, partial->I_N),
                rheology::friction_slope(law, std::nextafter(partial->I_N, 1e300)));
    out += line("A                 %.15g", partial->A);
  }
  out += points_text("neutral (C = 0)", rheology::branch_neutral_points(law));
  out += points_text("bound (q = 1)", rheology::branch_ellipticity_bounds(law));
  out +=
      "well-posed        " + ranges_text(rheology::ranges_of_condition(law)) + "   (C <= 0, the paper's condition)\n";
  out += "                  " + ranges_text(rheology::ranges_of_damping(law)) +
         "   (no short wave grows, linear theory)\n";
  return out;
}

}  // namespace talus::app
