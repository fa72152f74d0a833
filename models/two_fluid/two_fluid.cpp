#include "two_fluid/two_fluid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "two_fluid/terms/counter_gradient.hpp"
#include "two_fluid/terms/forces.hpp"
#include "two_fluid/terms/free_fall.hpp"
#include "two_fluid/terms/inertia.hpp"
#include "two_fluid/terms/stress.hpp"
#include "two_fluid/terms/transport.hpp"

namespace talus::two_fluid {
namespace {

/// Of what Newton's method leaves in the volume fraction of any one cell [1]: the bound that it is to keep is 1e-6.
constexpr double fraction_bound = 3e-7;

enum FieldNumber : std::uint8_t { field_u, field_w, field_phi, field_p, field_mass, field_H };

Budgets budgets_of(const Parameters& par, const Mesh& mesh) {
  const bool ends = !par.box.periodic, pours = par.inflow.rate > 0.0;
  return {pours, ends && par.box.left_open, ends && par.box.right_open, true,
          !pours                              ? 0
          : par.numerics.jet == Jet::resolved ? 1
                                              : mesh.fall().n_lines};
}

core::Layout make_layout(const Parameters& par, const Mesh& mesh, const Unknowns& at) {
  core::Layout layout;
  layout.fields = {{"u", "m s-1", core::Kind::differential, par.atol_velocity},
                   {"w", "m s-1", core::Kind::differential, par.atol_velocity},
                   {"phi", "1", core::Kind::differential, par.numerics.atol_fraction, fraction_bound},
                   {"p", "Pa", core::Kind::algebraic, par.atol_pressure},
                   {"mass", "kg", core::Kind::differential, par.atol_mass},
                   {"H", "m", core::Kind::differential, par.atol_height}};
  layout.field_of.assign(at.size(), field_u);
  for (const auto [i, k] : mesh.interfaces()) layout.field_of[at.w(i, k)] = field_w;
  for (const auto [i, k] : mesh.cells()) {
    layout.field_of[at.phi(i, k)] = field_phi;
    layout.field_of[at.p(i, k)] = field_p;
  }
  for (const Index budget : {at.mass_in(), at.mass_left(), at.mass_right(), at.mass_top()})
    if (budget >= 0) layout.field_of[budget] = field_mass;
  for (int line = 0; line < at.n_heaps(); ++line) layout.field_of[at.heap(line)] = field_H;
  return layout;
}

/// The equations: volume and grains, inertia, pressure and weight, stresses, friction, what is poured.
fv::Operator<Context>::Terms make_terms(const Parameters& par, const Mesh& mesh, const Unknowns& unknowns) {
  fv::Operator<Context>::Terms terms;
  const auto add = [&](auto kernel) { terms.push_back(fv::make_term<Context>(std::move(kernel))); };
  const auto at = [&](const std::vector<Place>& places) { return Kernel{&mesh, &unknowns, &places}; };
  add(TransportAlong{at(mesh.faces())});
  add(TransportUp{at(mesh.interfaces())});
  if (par.numerics.sharpening == Sharpening::counter_gradient) {
    add(CounterGradientAlong{at(mesh.faces())});
    add(CounterGradientUp{at(mesh.interfaces())});
  }
  add(Storage{at(mesh.cells())});
  Rates rates{at(mesh.cells()), {}};
  for (const Index row : {unknowns.mass_in(), unknowns.mass_left(), unknowns.mass_right(), unknowns.mass_top()})
    if (row >= 0) rates.rows.push_back(row);
  for (int line = 0; line < unknowns.n_heaps(); ++line) rates.rows.push_back(unknowns.heap(line));
  add(std::move(rates));
  add(MomentumAlong{at(mesh.faces())});
  add(MomentumUp{at(mesh.interfaces())});
  if (par.numerics.advection != Advection::none) {
    add(ConvectionAlongAlong{at(mesh.cells())});
    add(ConvectionUpUp{at(mesh.cells())});
    add(ConvectionAlongUp{at(mesh.corners())});
    add(ConvectionUpAlong{at(mesh.corners())});
  }
  add(CentreStress{at(mesh.cells())});
  add(CornerStress{at(mesh.corners())});
  add(BaseStress{at(mesh.base())});
  if (par.wall.mu_w > 0.0) {
    add(WallFrictionAlong{at(mesh.faces())});
    add(WallFrictionUp{at(mesh.interfaces())});
  }
  if (mesh.fall().n_lines > 0) {
    add(FreeFall{at(mesh.cells())});
    add(HeapOnLine{at(mesh.cells())});
    add(HeapOnLineRelaxation{at(mesh.cells())});
  } else if (par.inflow.rate > 0.0) {
    add(InletMomentum{at(mesh.inlet_corners())});
    add(HeapUnderJet{at(mesh.cells())});
    add(HeapRelaxation{at(mesh.cells())});
  }
  return terms;
}

}  // namespace

TwoFluid::TwoFluid(Parameters parameters)
    : parameters_(std::move(parameters)),
      mesh_(parameters_),
      unknowns_(mesh_, budgets_of(parameters_, mesh_)),
      layout_(make_layout(parameters_, mesh_, unknowns_)),
      operator_(std::make_unique<fv::Operator<Context>>(unknowns_.size(), make_terms(parameters_, mesh_, unknowns_),
                                                        context(0.0))) {}

Context TwoFluid::context(double t) const {
  const Parameters& par = parameters_;
  const double volume = experiment::inflow_rate(par.inflow, t) / (par.grains.rho() * par.box.gap);
  const double speed = par.inflow.rate > 0.0 ? volume / (par.numerics.inlet_fraction * inlet_width(par.inflow)) : 0.0;
  const Numerics& n = par.numerics;
  const double parting = n.sharpening == Sharpening::segregation ? n.segregation_speed : 0.0;
  const bool along_gravity = n.direction != Direction::base_normal;
  return {.parameters = &par,
          .mesh = &mesh_,
          .t = t,
          .inlet_speed = speed,
          .inlet_slip = par.inflow.along_gravity ? speed * std::tan(par.box.tilt) : 0.0,
          .poured = volume,
          .fall_x = par.inflow.along_gravity ? std::sin(par.box.tilt) : 0.0,
          .fall_z = par.inflow.along_gravity ? -std::cos(par.box.tilt) : -1.0,
          .rate_floor = rheology::rate_floor(par.regularisation, par.box.height),
          .gravity_x = par.box.gravity * std::sin(par.box.tilt),
          .gravity_z = -par.box.gravity * std::cos(par.box.tilt),
          .segregation_x = parting * (along_gravity ? std::sin(par.box.tilt) : 0.0),
          .segregation_z = -parting * (along_gravity ? std::cos(par.box.tilt) : 1.0),
          .air_drag = 12.0 * par.numerics.air.drag_viscosity / (par.box.gap * par.box.gap)};
}

void TwoFluid::initial_state(double t, std::span<double> y, std::span<double> yp) const {
  std::ranges::fill(y, 0.0);
  std::ranges::fill(yp, 0.0);
  const auto& g = mesh_.grid();
  const Context c = context(t);
  for (int i = 0; i < g.n_columns(); ++i) {
    double above = 0.0;  // pressure on the cell's upper interface
    for (int k = g.n_layers() - 1; k >= 0; --k) {
      if (!mesh_.has_cell(i, k)) continue;
      const double phi = std::clamp((parameters_.thickness - g.z_nodes[k]) / g.dz(k), 0.0, 1.0);
      const double weight = -c.gravity_z * c.excess() * phi * g.dz(k);
      y[unknowns_.phi(i, k)] = phi;
      y[unknowns_.p(i, k)] = above + 0.5 * weight;
      above += weight;
    }
  }
  for (const auto& step : mesh_.fall().steps)
    y[unknowns_.heap(step.line)] += (step.to - step.from) * densely_filled(y[unknowns_.phi(step.i, step.k)]);
}

void TwoFluid::residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const {
  operator_->residual(context(t), y, yp, r);
}

void TwoFluid::jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                        std::span<double> values) const {
  operator_->jacobian(context(t), y, yp, c_j, values);
}

std::string TwoFluid::describe(core::Index row) const {
  const auto& at = unknowns_;
  if (row == at.mass_in()) return "mass poured in";
  if (row == at.mass_left()) return "mass gone over the left end";
  if (row == at.mass_right()) return "mass gone over the right end";
  if (row == at.mass_top()) return "mass gone through the top or the edge of the cells";
  for (int line = 0; line < at.n_heaps(); ++line)
    if (row == at.heap(line)) return "H under the jet" + (line > 0 ? ", line " + std::to_string(line) : "");
  const auto& g = mesh_.grid();
  const auto text = [&](const char* where, int i, int k, double x, double z) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, "%s at %s %d, %d (x = %.5g m, z = %.5g m)", layout_.field(row).name.c_str(),
                  where, i, k, x, z);
    return std::string(buffer);
  };
  for (const auto [f, k] : mesh_.faces())
    if (row == at.u(f, k)) return text("face, layer", f, k, g.x_nodes[f], g.z_centre(k));
  for (const auto [i, k] : mesh_.interfaces())
    if (row == at.w(i, k)) return text("column, interface", i, k, g.x_centre(i), g.z_nodes[k]);
  for (const auto [i, k] : mesh_.cells())
    if (row == at.phi(i, k) || row == at.p(i, k)) return text("column, layer", i, k, g.x_centre(i), g.z_centre(k));
  throw std::out_of_range("TwoFluid::describe: no such row");
}

std::vector<double> TwoFluid::breakpoints() const { return experiment::breakpoints(parameters_.inflow); }

}  // namespace talus::two_fluid
