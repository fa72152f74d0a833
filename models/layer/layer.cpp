#include "layer/layer.hpp"

#include <cmath>
#include <cstdio>

#include "core/errors.hpp"
#include "layer/film.hpp"
#include "layer/terms/continuity.hpp"
#include "layer/terms/forces.hpp"
#include "layer/terms/given.hpp"
#include "layer/terms/inertia.hpp"
#include "layer/terms/lid.hpp"
#include "layer/terms/stress.hpp"
#include "layer/terms/top_stress.hpp"

namespace talus::layer {

namespace {

enum FieldNumber : std::uint8_t { field_u, field_omega, field_p, field_H, field_mass };

Budgets budgets_of(const Parameters& par) {
  const bool ends = !par.box.periodic;
  return {par.inflow.rate > 0.0, ends && par.box.left_open, ends && par.box.right_open};
}

Edges edges_of(const Box& box) {
  return {!box.left_open, !box.right_open, box.end_walls == Contact::no_slip, box.lid.has_value()};
}

core::Layout make_layout(const Parameters& par, const grid::Columns& c, const Unknowns& unknowns) {
  core::Layout layout;
  layout.fields = {{"u", "m s-1", core::Kind::differential, par.atol_velocity},
                   {"omega", "m s-1", core::Kind::differential, par.atol_velocity},
                   {"p", "Pa", core::Kind::algebraic, par.atol_pressure},
                   {"H", "m", par.box.lid ? core::Kind::algebraic : core::Kind::differential, par.atol_height},
                   {"mass", "kg", core::Kind::differential, par.atol_mass}};
  layout.field_of.assign(unknowns.size(), field_u);
  for (int i = 0; i < c.n_columns; ++i) {
    for (int k = 0; k < c.n_layers; ++k) {
      if (unknowns.omega(i, k + 1) >= 0) layout.field_of[unknowns.omega(i, k + 1)] = field_omega;
      layout.field_of[unknowns.p(i, k)] = field_p;
    }
    layout.field_of[unknowns.H(i)] = field_H;
  }
  for (const Index budget : {unknowns.mass_in(), unknowns.mass_left(), unknowns.mass_right()})
    if (budget >= 0) layout.field_of[budget] = field_mass;
  return layout;
}

std::vector<Index> rates_alone(const Kernel& at) {
  std::vector<Index> rows;
  for (int i = 0; i < at.columns.n_columns; ++i)
    if (at.unknowns.surface(i) >= 0) rows.push_back(at.unknowns.surface(i));
  for (const Index budget : {at.unknowns.mass_in(), at.unknowns.mass_left(), at.unknowns.mass_right()})
    if (budget >= 0) rows.push_back(budget);
  return rows;
}

/// The equations: continuity and surface, inertia, stress, friction, pressure and weight, and what is given.
fv::Operator<Context>::Terms make_terms(const Parameters& par, const Kernel& at) {
  fv::Operator<Context>::Terms terms;
  const auto add = [&](auto kernel) { terms.push_back(fv::make_term<Context>(std::move(kernel))); };
  add(FaceFlux{at});
  add(InterfaceFlux{at});
  add(Rate{at, rates_alone(at)});
  if (par.inflow.rate > 0.0) {
    add(JetSource{at});
    add(Poured{at});
    if (par.inflow.momentum) add(JetMomentum{at});
  }
  add(Acceleration{at});
  if (par.numerics.advection != Advection::none) {
    add(ConvectionAlong{at});
    add(ConvectionAcross{at});
  }
  add(CornerStress{{at}, {}});
  if (par.box.lid) {
    add(LidStress{at});
    add(LidHeight{at});
    add(PressureLevel{at});
  } else if (par.fluid) {
    add(SurfaceStress{at});
  }
  add(CentreStress{{at}, {}});
  if (par.wall.mu_w > 0.0) add(WallFriction{at});
  add(PressureAlong{at});
  add(PressureAcross{at});
  if (par.forcing) {
    add(GivenForce{at});
    if (!par.box.lid) {
      add(GivenPull{at});
      add(GivenPressure{at});
    }
  }
  return terms;
}

}  // namespace

Layer::Layer(Parameters parameters)
    : parameters_(std::move(parameters)),
      columns_{parameters_.grid.columns, parameters_.grid.layers, parameters_.box.length, parameters_.box.periodic},
      layering_(parameters_.grid.layers, parameters_.grid.cluster_depth, parameters_.grid.spacing),
      unknowns_(columns_, edges_of(parameters_.box), budgets_of(parameters_)),
      layout_(make_layout(parameters_, columns_, unknowns_)) {
  if (columns_.n_columns < 1 || columns_.n_layers < 2)
    throw std::invalid_argument("layer: needs a column and two layers");
  const Box& box = parameters_.box;
  if (box.lid && !box.periodic && (box.left_open || box.right_open))
    throw std::invalid_argument("layer: under a lid both ends must be walls, or joined");
  const auto& initial = parameters_.initial;
  if (!initial.speeds.empty() && initial.speeds.size() != static_cast<std::size_t>(columns_.n_layers))
    throw std::invalid_argument("layer: needs a speed of each layer at the start, or none");
  if ((!initial.speeds.empty() || initial.disturbance) && !box.periodic)
    throw std::invalid_argument("layer: speeds at the start belong to a periodic layer");
  context_.parameters = &parameters_;
  context_.columns = columns_;
  context_.weight_along = parameters_.grains.rho() * box.gravity * std::sin(box.tilt);
  context_.weight_down = parameters_.grains.rho() * box.gravity * std::cos(box.tilt);
  const std::size_t n_heights = std::size_t(columns_.n_columns) * (columns_.n_layers + 1);
  context_.z.resize(n_heights);
  context_.dz.resize(n_heights);
  context_.d2z.resize(n_heights);
  context_.slope.assign(n_heights + columns_.n_layers + 1, box.base_slope);
  context_.mobility.resize(columns_.n_columns);
  context_.film_share.resize(columns_.n_faces());
  std::vector<double> y(unknowns_.size()), yp(unknowns_.size());
  initial_state(0.0, y, yp);
  operator_ = std::make_unique<fv::Operator<Context>>(unknowns_.size(), make_terms(parameters_, {columns_, unknowns_}),
                                                      context(0.0, y));
}

const Context& Layer::context(double t, std::span<const double> y) const {
  context_.t = t;
  const int n = columns_.n_layers + 1;
  for (int i = 0; i < columns_.n_columns; ++i) {
    const double H = y[unknowns_.H(i)];
    if (!(H > 0.0) || !std::isfinite(H)) throw core::InadmissibleState(describe(unknowns_.H(i)) + " is not positive");
    const std::size_t a = context_.at(i, 0);
    layering_.heights(H, {&context_.z[a], std::size_t(n)}, {&context_.dz[a], std::size_t(n)},
                      {&context_.d2z[a], std::size_t(n)});
    context_.mobility[i] = mobility(parameters_.numerics, core::Dual<1>::input(H, 0));
  }
  for (int i = 0; i < columns_.n_columns; ++i) {
    const double *left = &context_.z[context_.at(i - 1, 0)], *right = &context_.z[context_.at(i + 1, 0)];
    double* slope = &context_.slope[context_.at(i, 0)];
    for (int k = 0; k < n; ++k) slope[k] = (right[k] - left[k]) * (0.5 / columns_.dx()) + parameters_.box.base_slope;
  }
  for (int f = 0; f < columns_.n_faces(); ++f)
    context_.film_share[f] = 1.0 - heap_share(parameters_.numerics, core::Dual<2>::input(y[unknowns_.H(f - 1)], 0),
                                              core::Dual<2>::input(y[unknowns_.H(f)], 1));
  return context_;
}

void Layer::initial_state(double, std::span<double> y, std::span<double> yp) const {
  std::fill(y.begin(), y.end(), 0.0);
  std::fill(yp.begin(), yp.end(), 0.0);
  const double weight = context_.weight_down;
  const double H = parameters_.initial.thickness;
  const double above = parameters_.box.lid ? parameters_.box.lid->pressure : 0.0;
  std::vector<double> z(columns_.n_layers + 1), dz(z), d2z(z);
  layering_.heights(H, z, dz, d2z);
  for (int i = 0; i < columns_.n_columns; ++i) {
    y[unknowns_.H(i)] = H;
    for (int k = 0; k < columns_.n_layers; ++k) y[unknowns_.p(i, k)] = above + weight * (H - 0.5 * (z[k] + z[k + 1]));
  }
  if (!parameters_.initial.speeds.empty() || parameters_.initial.disturbance) set_speeds(z, y);
}

void Layer::set_speeds(std::span<const double> z, std::span<double> y) const {
  const auto& initial = parameters_.initial;
  const int n = columns_.n_columns;
  std::vector<double> x, middle, added(std::size_t(n) * columns_.n_layers, 0.0);
  for (int f = 0; f < n; ++f) x.push_back(columns_.x_face(f) / parameters_.box.length);
  for (int k = 0; k < columns_.n_layers; ++k) middle.push_back(0.5 * (z[k] + z[k + 1]) / initial.thickness);
  if (initial.disturbance) added = sampled(*initial.disturbance, x, middle);
  for (int k = 0; k < columns_.n_layers; ++k)
    for (int f = 0; f < n; ++f)
      y[unknowns_.u(f, k)] = (initial.speeds.empty() ? 0.0 : initial.speeds[k]) + added[std::size_t(k) * n + f];
}

void Layer::residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const {
  operator_->residual(context(t, y), y, yp, r);
}

void Layer::jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                     std::span<double> values) const {
  operator_->jacobian(context(t, y), y, yp, c_j, values);
}

std::string Layer::describe(core::Index row) const {
  const auto text = [](auto... arguments) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, arguments...);
    return std::string(buffer);
  };
  if (row == unknowns_.mass_in()) return "mass poured in";
  if (row == unknowns_.mass_left()) return "mass gone over the left end";
  if (row == unknowns_.mass_right()) return "mass gone over the right end";
  int i = 0;
  while (i < columns_.n_columns && row > unknowns_.H(i)) ++i;
  const auto field = layout_.field_of[row];
  int k = 0;
  const auto number = [&] {
    if (field == field_u) return unknowns_.u(i, k);
    return field == field_omega ? unknowns_.omega(i, k + 1) : unknowns_.p(i, k);
  };
  while (k < columns_.n_layers && number() != row) ++k;
  const double x = field == field_u ? columns_.x_face(i) : columns_.x_centre(i);
  if (field == field_H) return text("H of column %d (x = %.5g m)", i, x);
  return text("%s at %s %d, %s %d of %d (x = %.5g m)", layout_.fields[field].name.c_str(),
              field == field_u ? "face" : "column", i, field == field_omega ? "interface" : "layer",
              field == field_omega ? k + 1 : k, columns_.n_layers, x);
}

std::vector<double> Layer::breakpoints() const { return experiment::breakpoints(parameters_.inflow); }

}  // namespace talus::layer
