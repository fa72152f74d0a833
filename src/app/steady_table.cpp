#include "app/steady_table.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/steady_quantities.hpp"
#include "app/table.hpp"

namespace talus::app {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string digits(double value, int significant = 5) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", significant, value);
  return text.data();
}
std::string millimetres(double metres) { return digits(1e3 * metres, 4); }

/// The depths outside `ranges`, in mm: "all", "none", "below 0.6", "0.6 to 3.4", ...
std::string outside(const std::vector<steady::DepthRange>& ranges, double end) {
  if (ranges.empty()) return "all";
  std::string out;
  double from = 0.0;
  const auto add = [&](double to) {
    if (!(to > from)) return;
    const std::string words = from == 0.0 ? "above " + millimetres(to)
                              : to == end ? "below " + millimetres(from)
                                          : millimetres(from) + " to " + millimetres(to);
    out += (out.empty() ? "" : ", ") + words;
  };
  for (const auto& range : ranges) {
    add(range.from);
    from = range.to;
  }
  add(end);
  return out.empty() ? "none" : out;
}

std::string heading(const SteadyStudy& study) {
  const auto& c = study.channel;
  std::string out = "Steady uniform flow, " + std::string(rheology::name(c.law)) +
                    " law, d = " + millimetres(c.grains.d) + " mm, gap W = " + millimetres(c.gap) +
                    " mm, mu_w = " + digits(c.mu_w) + ", g = " + digits(c.gravity) + " m/s2; ";
  return out + (std::isfinite(study.thickness)
                    ? "a layer " + millimetres(study.thickness) + " mm thick over a no-slip base\n\n"
                    : "a heap, no base\n\n");
}

/// A column of words about each flow.
template <class F>
Column column(std::string name, const std::vector<const SteadyFlow*>& flows, F&& words) {
  std::vector<std::string> cells;
  for (const auto* flow : flows) cells.push_back(words(*flow));
  return {std::move(name), "", "", std::move(cells)};
}

std::string table(const SteadyStudy& study) {
  std::vector<const SteadyFlow*> flows;
  for (const auto& each : study.cases)
    if (each.flow) flows.push_back(&*each.flow);
  if (flows.empty()) return "";
  using S = SteadyFlow;
  return text_of({column("zeta_deg", flows, [](const S& s) { return digits(s.flow.zeta() / degree, 6); }),
                  column("Q_kg_s", flows, [](const S& s) { return digits(s.flux, 6); }),
                  column("u_surface_m_s", flows, [](const S& s) { return digits(s.surface_speed); }),
                  column("I_surface", flows, [](const S& s) { return digits(s.flow.inertial_number(0.0)); }),
                  column("z_st_mm", flows,
                         [](const S& s) { return std::isfinite(s.flow.z_st()) ? millimetres(s.flow.z_st()) : "-"; }),
                  column("50%_mm", flows, [](const S& s) { return millimetres(s.half_depth); }),
                  column("1%_mm", flows, [](const S& s) { return millimetres(s.percent_depth); }),
                  column("u_mean_m_s", flows, [](const S& s) { return digits(s.mean.speed); }),
                  column("Froude", flows, [](const S& s) { return digits(s.mean.froude); }),
                  column("over_mm", flows,
                         [](const S& s) { return millimetres(s.mean.depth) + (s.mean.to_base ? " base" : " 1%"); }),
                  column("C<=0_at_mm", flows, [](const S& s) { return outside(s.posed.C_positive, s.flow.depth()); }),
                  column("q<1_at_mm", flows, [](const S& s) { return outside(s.posed.q_beyond, s.flow.depth()); })});
}

std::string name_of(SteadyGiven given, double value) {
  const std::string number = shortest(value);
  switch (given) {
    case SteadyGiven::zeta: return "zeta = " + number + " degrees";
    case SteadyGiven::flux: return "Q = " + number + " kg/s";
    default: return "depth-averaged speed " + number + " m/s";
  }
}

std::string absences(const SteadyStudy& study) {
  std::string out;
  for (const auto& each : study.cases)
    if (!each.flow) out += name_of(study.given, each.given) + ": " + each.reason + "\n";
  return out;
}

std::string legend(const SteadyStudy& study) {
  std::string out;
  if (study.steepest) {
    out += "Steady flow exists below " + digits(*study.steepest / degree, 6) + " degrees";
    if (study.maximal_flux) out += " and up to Q_max = " + digits(*study.maximal_flux, 6) + " kg/s";
    out += ".\n";
  }
  const auto points = [](const std::vector<double>& all) {
    std::string list;
    for (const double I : all) list += (list.empty() ? "" : ", ") + digits(I, 6);
    return list.empty() ? "no I" : "I = " + list;
  };
  return out + "C (3.18) changes its sign at " + points(study.bounds.neutral) + "; q - 1 at " +
         points(study.bounds.q_is_one) +
         ".\nDepths are below the surface. Means are over the depth in over_mm: to the base, or to 1 % of the surface "
         "speed.\n";
}

std::string profile(const SteadyFlow& s) {
  Table columns;
  for (const auto& each : steady_profiles()) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < s.depths.size(); ++i) cells.push_back(digits(each.value(s, i)));
    columns.push_back({std::string(each.name) + each.suffix, each.unit, each.long_name, std::move(cells)});
  }
  return "\nzeta = " + digits(s.flow.zeta() / degree, 6) + " degrees\n" + text_of(columns);
}

}  // namespace

std::string steady_table(const SteadyStudy& study, bool profiles) {
  std::string out = heading(study) + table(study);
  const std::string none = absences(study);
  if (!none.empty()) out += (out.ends_with("\n\n") ? "" : "\n") + none;
  out += "\n" + legend(study);
  if (profiles)
    for (const auto& each : study.cases)
      if (each.flow) out += profile(*each.flow);
  return out;
}

}  // namespace talus::app
