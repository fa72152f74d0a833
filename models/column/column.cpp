#include "column/column.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "column/terms/momentum.hpp"

namespace talus::column {
namespace {

void check(const Parameters& par) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(std::string("column: ") + what);
  };
  rheology::check(par.regularisation);
  require(par.grid.layers >= 2, "layers must be at least 2");
  require(par.thickness > 0.0 && std::isfinite(par.thickness), "thickness must be above 0 m and finite");
  require(par.wall.mu_w >= 0.0, "mu_w must be at least 0");
  require(par.wall.u_c > 0.0, "u_c must be above 0 m/s");
  require(par.box.gap > 0.0 && std::ranges::all_of(par.motion.gap.values, [](double W) { return W > 0.0; }),
          "the gap must be above 0 m at any time");
  require(is_sound(par.motion.tilt) && is_sound(par.motion.gap),
          "the motion needs a value a time, and times must ascend");
  require(is_sound(par.start), "the start needs a speed a depth, and depths must ascend");
}

core::Layout make_layout(const Parameters& par) {
  return {.fields = {{"u", "m s-1", core::Kind::differential, par.atol_velocity}},
          .field_of = std::vector<std::uint8_t>(par.grid.layers, 0)};
}

/// The equation: inertia and weight, wall friction, shear stress.
fv::Operator<Context>::Terms make_terms(const Parameters& par) {
  const Kernel at{par.grid.layers};
  fv::Operator<Context>::Terms terms;
  terms.push_back(fv::make_term<Context>(Fall{at}));
  if (par.wall.mu_w > 0.0) terms.push_back(fv::make_term<Context>(WallFriction{at}));
  terms.push_back(fv::make_term<Context>(ShearStress{at}));
  return terms;
}

const Parameters& checked(const Parameters& par) {
  check(par);
  return par;
}

}  // namespace

Heights::Heights(const Parameters& par) : interface(par.grid.layers + 1) {
  std::vector<double> dz(interface.size()), d2z(interface.size());
  grid::Layering(par.grid.layers, par.grid.cluster_depth, par.grid.spacing).heights(par.thickness, interface, dz, d2z);
  for (int k = 0; k < par.grid.layers; ++k) centre.push_back(0.5 * (interface[k] + interface[k + 1]));
}

Column::Column(Parameters parameters)
    : parameters_(std::move(parameters)),
      heights_(checked(parameters_)),
      layout_(make_layout(parameters_)),
      operator_(std::make_unique<fv::Operator<Context>>(layout_.size(), make_terms(parameters_), context(0.0))) {}

Context Column::context(double t) const {
  const auto& par = parameters_;
  const auto box = experiment::box_at(par.box, par.motion, t);
  const double zeta = experiment::base_angle(box), weight = par.grains.rho() * box.gravity;
  return {.parameters = &par,
          .heights = &heights_,
          .weight = weight * std::sin(zeta),
          .lithostatic = weight * std::cos(zeta),
          .wall_friction = 2.0 * par.wall.mu_w / box.gap,
          .rate_floor = rheology::rate_floor(par.regularisation, par.thickness)};
}

void Column::initial_state(double t, std::span<double> y, std::span<double> yp) const {
  for (int k = 0; k < heights_.n_layers(); ++k)
    y[k] = experiment::value_at(parameters_.start, heights_.surface() - heights_.centre[k], 0.0);
  std::vector<double> force(y.size());
  std::ranges::fill(yp, 0.0);
  residual(t, y, yp, force);
  for (int k = 0; k < heights_.n_layers(); ++k) yp[k] = -force[k] / (parameters_.grains.rho() * heights_.thickness(k));
}

void Column::residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const {
  operator_->residual(context(t), y, yp, r);
}

void Column::jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                      std::span<double> values) const {
  operator_->jacobian(context(t), y, yp, c_j, values);
}

std::string Column::describe(core::Index row) const {
  char text[96];
  std::snprintf(text, sizeof text, "u in layer %d of %d (z = %.5g m)", static_cast<int>(row), heights_.n_layers(),
                heights_.centre[row]);
  return text;
}

std::vector<double> Column::breakpoints() const {
  std::vector<double> times = parameters_.motion.tilt.at;
  times.insert(times.end(), parameters_.motion.gap.at.begin(), parameters_.motion.gap.at.end());
  std::ranges::sort(times);
  times.erase(std::ranges::unique(times).begin(), times.end());
  return times;
}

}  // namespace talus::column
