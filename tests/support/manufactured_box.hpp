#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "support/layer_cases.hpp"
#include "support/manufactured_forcing.hpp"
#include "support/reference.hpp"
#include "support/table.hpp"

/// Manufactured solutions in a closed box with given velocities on base and lid, of a fluid and of mu(I) grains, without and with
/// side-wall friction.
namespace talus::tests {

using nlohmann::json;

inline const json& solution(const std::string& name) {
  static const json all = support::reference("manufactured.json");
  for (const auto& each : all.at("cases"))
    if (each.at("name") == name) return each;
  throw std::runtime_error("no manufactured solution " + name);
}

inline Flow flow_of(const json& c) {
  const double U0 = c.at("U0"), G = c.at("G"), a = c.at("a"), b = c.at("b"), om = c.at("om"), p0 = c.at("p0"),
               weight = c.at("rho").get<double>() * c.at("gz").get<double>();
  return [=](const Taylor2& x, const Taylor2& z, const Taylor2& t) {
    const auto beat = cos(om * t), wave = cos(2.0 * std::numbers::pi * x);
    return FlowAt{U0 + G * z + a * beat * sin(2.0 * std::numbers::pi * x) * cos(2.0 * std::numbers::pi * z),
                  -a * beat * wave * sin(2.0 * std::numbers::pi * z),
                  p0 - weight * z + b * beat * wave * sin(std::numbers::pi * z)};
  };
}

inline rheology::Grains grains_of(const json& c) {
  return rheology::grains(c.at("rhos"), c.at("rho").get<double>() / c.at("rhos").get<double>(), c.at("d"));
}
inline rheology::PartiallyRegularised law_of(const json& c) {
  return rheology::partially_regularised(rheology::classical(c.at("mus"), c.at("mud"), c.at("I0")), c.at("muinf"), 1.9,
                                         0.05);  // all I are above
}

inline Medium medium_of(const std::string& name, const json& c) {
  Medium medium;
  medium.rho = c.at("rho");
  medium.weight = {0.0, -medium.rho * c.at("gz").get<double>()};
  medium.wall_friction = 2.0 * c.at("muw").get<double>() / c.at("W").get<double>();
  if (name == "newton")
    medium.viscosity = [eta = c.at("eta").get<double>()](const Taylor2&, const Taylor2&) { return Taylor2(eta); };
  else medium.viscosity = grain_viscosity(law_of(c), grains_of(c));
  return medium;
}

inline layer::Parameters parameters_of(const std::string& name, const json& c, int n) {
  auto par = fluid_box(c.at("eta"), n, n);
  par.box.gravity = c.at("gz");
  par.box.gap = c.at("W");
  par.grains = grains_of(c);
  par.wall = {.mu_w = c.at("muw"), .u_c = 1e-2};  // all speeds are far above
  if (name == "newton") return par;
  par.fluid.reset();
  par.law = law_of(c);
  return par;
}

struct BoxCase {
  std::string solution, grid;
  grid::Spacing spacing;
  layer::Advection advection = layer::Advection::central;
  std::vector<int> cells = {8, 16, 32};
  double order_u = 1.8, order_p = 1.7;  ///< at least, between the last two grids
  double slip_length = 0.0;             ///< of the base [m]
};
inline void PrintTo(const BoxCase& c, std::ostream* out) { *out << c.solution << " " << c.grid; }

inline void expect_box_order(const std::string& table_name, const BoxCase& c) {
  const double end = 0.3;
  const auto& reference = solution(c.solution).at("parameters");
  Table table(table_name, {"cells", "L2 of u [m/s]", "L2 of w [m/s]", "L2 of p [Pa]", "Linf of u [m/s]",
                           "Linf of w [m/s]", "Linf of p [Pa]", "order u", "order w", "order p", "order Linf p"});
  std::vector<double> h, u, w, p, p_most;
  for (const int n : c.cells) {
    auto par = parameters_of(c.solution, reference, n);
    par.numerics.advection = c.advection;
    par.box.base_slip_length = c.slip_length;
    par.grid.spacing = c.spacing;
    par.grid.cluster_depth = 0.5;  // the lowest layer is three times as thick as the uppermost
    const auto forcing =
        std::make_shared<ManufacturedForcing>(par, flow_of(reference), medium_of(c.solution, reference),
                                              [](const Taylor2&, const Taylor2&) { return Taylor2(1.0); });
    par.forcing = forcing;
    const layer::Layer system(par);
    const auto exact = [&](double x, double z, double t) { return forcing->exact(x, z, t); };
    auto y = state_at_rest(system);
    set_flow(system, exact, 0.0, y);
    integrate(system, 0.0, end, y, 1e-7);
    const auto e = errors(system, exact, end, y);
    h.push_back(1.0 / n), u.push_back(e.u.l2), w.push_back(e.w.l2), p.push_back(e.p.l2), p_most.push_back(e.p.linf);
    const auto order = [&](const std::vector<double>& v) {
      return v.size() == 1 ? Table::Cell("") : diagnostics::observed_orders(h, v).back();
    };
    table.row(
        {double(n), e.u.l2, e.w.l2, e.p.l2, e.u.linf, e.w.linf, e.p.linf, order(u), order(w), order(p), order(p_most)});
  }
  EXPECT_GT(diagnostics::observed_orders(h, u).back(), c.order_u);
  EXPECT_GT(diagnostics::observed_orders(h, w).back(), c.order_u);
  EXPECT_GT(diagnostics::observed_orders(h, p).back(), c.order_p);
}

}  // namespace talus::tests
