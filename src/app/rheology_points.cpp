#include "app/rheology_points.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "rheology/well_posedness.hpp"
#include "steady/bagnold.hpp"

namespace talus::app {
namespace {

using rheology::Law;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

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
    angle.push_back(0.5 * std::asin(rheology::worst_direction(r)) / degree);
    scale.push_back(at > 0.0 ? rheology::growth_scale(grains, r, at, 1.0 / grains.d) : none);
  }
};

Column growth_at(double k, const rheology::Grains& grains, const Columns& c) {
  std::vector<double> rate;
  const double kd = k * grains.d;
  for (std::size_t i = 0; i < c.growth.size(); ++i) rate.push_back(c.growth[i] * c.scale[i] * kd * kd);
  return {"growth_k" + shortest(k), "1", "growth_max over the shear rate at k = " + shortest(k) + " 1/m",
          std::move(rate)};
}

void add_bagnold(Table& table, const steady::Channel& channel, const std::vector<double>& zeta, double thickness) {
  std::vector<double> surface, mean, flux, froude;
  for (const double each : zeta) {
    const auto flow = steady::BagnoldFlow::at(channel, each * degree, thickness);
    surface.push_back(flow ? flow->surface_speed() : none);
    mean.push_back(flow ? flow->mean_speed() : none);
    flux.push_back(flow ? flow->flux() : none);
    froude.push_back(flow ? flow->froude() : none);
  }
  const std::string of = " of a layer " + shortest(thickness) + " m thick, without side walls (B2)";
  table.push_back({"bagnold_surface_m_s", "m/s", "surface speed" + of, surface});
  table.push_back({"bagnold_mean_m_s", "m/s", "mean speed" + of, mean});
  table.push_back({"bagnold_flux_kg_m_s", "kg/(m s)", "mass flow a metre of width" + of, flux});
  table.push_back({"bagnold_froude", "1", "mean speed over sqrt(g h cos zeta)" + of, froude});
}

}  // namespace

Table rheology_table(const steady::Channel& channel, const RheologyPoints& points, std::vector<std::string>& notes) {
  Columns c;
  const auto add_friction = [&](double mu) {
    std::string reason;
    const double I = inverse_or_none(channel.law, mu, reason);
    if (reason.empty()) return c.add(channel.law, channel.grains, I);
    c.add_none();
    notes.push_back(reason);
  };
  for (const double I : points.I) c.add(channel.law, channel.grains, I);
  for (const double mu : points.mu) add_friction(mu);
  for (const double zeta : points.zeta) add_friction(std::tan(zeta * degree));
  Table table;
  if (!points.mu.empty()) table.push_back({"mu_given", "1", "friction asked for", points.mu});
  if (!points.zeta.empty()) table.push_back({"zeta_deg", "degree", "slope whose tangent is the friction", points.zeta});
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
  for (const double k : points.k) table.push_back(growth_at(k, channel.grains, c));
  if (points.thickness) add_bagnold(table, channel, points.zeta, *points.thickness);
  return table;
}

}  // namespace talus::app
