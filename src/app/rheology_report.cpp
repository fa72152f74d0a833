#include "app/rheology_report.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "app/words.hpp"
#include "rheology/neutral_points.hpp"
#include "rheology/well_posedness.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using rheology::Law;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class... Arguments>
std::string line(const char* pattern, Arguments... arguments) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), pattern, arguments...);
  return std::string(text.data()) + "\n";
}

double inverse_or_none(const Law& law, double mu, std::string& reason) {
  try {
    return rheology::inverse(law, mu);
  } catch (const std::domain_error& error) {
    reason = error.what();
    return none;
  }
}

const char* word_of(rheology::WellPosedness state) {
  switch (state) {
    case rheology::WellPosedness::well_posed: return "well_posed";
    case rheology::WellPosedness::damped: return "damped";
    case rheology::WellPosedness::ill_posed: return "ill_posed";
  }
  return "";
}

Json parameters(const rheology::Classical& law) { return {{"mu_s", law.mu_s}, {"mu_d", law.mu_d}, {"I_0", law.I_0}}; }
Json parameters(const rheology::Constant& law) { return {{"mu_s", law.mu_s}}; }
Json parameters(const rheology::PartiallyRegularised& law) {
  return {{"mu_s", law.mu_s}, {"mu_d", law.mu_d}, {"mu_inf", law.mu_inf},
          {"I_0", law.I_0},   {"I_N", law.I_N},   {"alpha", law.alpha}};
}

/// The columns that every point has.
struct Columns {
  std::vector<double> I, mu, slope, inverse, nu, q, C, growth, angle, scale;
  std::vector<std::string> state;

  void add_none() {
    for (auto* column : {&I, &mu, &slope, &inverse, &nu, &q, &C, &growth, &angle, &scale}) column->push_back(none);
    state.emplace_back("-");
  }

  void add(const Law& law, const rheology::Grains& grains, double at) {
    const auto r = rheology::response(law, at);
    std::string unused;
    I.push_back(at);
    mu.push_back(r.mu);
    slope.push_back(rheology::friction_slope(law, at));
    inverse.push_back(inverse_or_none(law, r.mu, unused));
    nu.push_back(r.nu);
    q.push_back(r.q);
    C.push_back(rheology::condition_C(r));
    state.emplace_back(word_of(rheology::well_posedness(r)));
    growth.push_back(rheology::max_growth(r));
    angle.push_back(0.5 * std::asin(rheology::worst_direction(r)) * 180.0 / std::numbers::pi);
    scale.push_back(at > 0.0 ? rheology::growth_scale(grains, r, at, 1.0 / grains.d) : none);
  }
};

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

Table rheology_table(const Law& law, const rheology::Grains& grains, const RheologyPoints& points,
                     std::vector<std::string>& notes) {
  Columns c;
  for (const double I : points.I) c.add(law, grains, I);
  for (const double mu : points.mu) {
    std::string reason;
    const double I = inverse_or_none(law, mu, reason);
    if (reason.empty()) c.add(law, grains, I);
    else {
      c.add_none();
      notes.push_back(reason);
    }
  }
  Table table;
  if (!points.mu.empty()) table.push_back({"mu_given", "1", "friction asked for", points.mu});
  table.push_back({"I", "1", "inertial number", c.I});
  table.push_back({"mu", "1", "friction mu(I)", c.mu});
  table.push_back({"dmu_dI", "1", "slope of mu, at I_N that of creep", c.slope});
  table.push_back({"I_of_mu", "1", "inertial number found back from mu(I)", c.inverse});
  table.push_back({"nu", "1", "I mu'/mu", c.nu});
  table.push_back({"q", "1", "mu - I mu'/2", c.q});
  table.push_back({"C", "1", "condition (3.18): well-posed where C <= 0", c.C});
  table.push_back({"state", "", "well_posed: C <= 0; damped: C > 0, yet nu > 1/2 and q < 1; ill_posed", c.state});
  table.push_back({"growth_max", "eta k^2/rho", "frozen-coefficient growth rate of the fastest wave", c.growth});
  table.push_back({"worst_angle_deg", "degree", "of that wave vector against the flow, or 90 less it", c.angle});
  table.push_back({"scale", "1", "eta/(rho d^2) over the shear rate, mu/(Phi I^2)", c.scale});
  for (const double k : points.k) {
    std::vector<double> rate;
    for (std::size_t i = 0; i < c.growth.size(); ++i) {
      const double kd = k * grains.d;
      rate.push_back(c.growth[i] * c.scale[i] * kd * kd);
    }
    std::array<char, 40> name{};
    std::snprintf(name.data(), name.size(), "growth_k%.6g", k);
    table.push_back({name.data(), "1", "sigma_max over the shear rate at that wave number [1/m]", std::move(rate)});
  }
  return table;
}

std::string law_word(const Law& law) {
  static const auto names = words::of(words::laws);
  return names[law.index()];
}

Json rheology_summary(const Law& law) {
  Json out;
  out["parameters"] = std::visit([](const auto& each) { return parameters(each); }, law);
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
