#include "triangle/triangle.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/errors.hpp"
#include "triangle/outflow.hpp"

namespace talus::triangle {
namespace {

/// What is poured enters the heap; what flows down its face leaves it over the right end.
struct Balance {
  static constexpr int n_in = Triangle::n_unknowns, n_out = Triangle::n_unknowns;
  static constexpr bool uses_rate = true;

  [[nodiscard]] Index n_places() const { return 1; }
  void connect(Index /*place*/, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {Triangle::mass, Triangle::mass_in, Triangle::mass_right};
    out = in;
  }
  template <class S>
  void evaluate(const Context& c, Index /*place*/, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const S outflow = core::lift(c.outflow, c.outflow_slope, in.y[Triangle::mass]);
    out[Triangle::mass] += in.rate[Triangle::mass] - c.inflow + outflow;
    out[Triangle::mass_in] += in.rate[Triangle::mass_in] - c.inflow;
    out[Triangle::mass_right] += in.rate[Triangle::mass_right] - outflow;
  }
};

const Parameters& checked(const Parameters& par) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(std::string("triangle: ") + what);
  };
  steady::check(par.channel);
  require(par.channel.mu_w > 0.0, "without wall friction no heap stands on the base: mu_w must be above 0");
  require(!par.box.periodic && par.box.left_open, "both ends of the box must be open");
  require(par.columns >= 1, "the surface needs a column to be written at");
  constexpr double quarter = 0.5 * std::numbers::pi;
  require(par.box.tilt >= 0.0 && par.left_slope + par.box.tilt > 0.0 && par.left_slope + par.box.tilt < quarter,
          "the left face must rise over the base, and not overhang");
  require(Frame(par).landing > 0.0 && Frame(par).landing < par.box.length, "the jet must fall into the box");
  return par;
}

fv::Operator<Context>::Terms make_terms() {
  fv::Operator<Context>::Terms terms;
  terms.push_back(fv::make_term<Context>(Balance{}));
  return terms;
}

}  // namespace

Triangle::Triangle(Parameters parameters)
    : parameters_(std::move(parameters)),
      frame_(checked(parameters_)),
      layout_{.fields = {{"mass", "kg", core::Kind::differential, parameters_.atol_mass}},
              .field_of = std::vector<std::uint8_t>(n_unknowns, 0)},
      operator_(std::make_unique<fv::Operator<Context>>(n_unknowns, make_terms(), Context{})) {}

template <class S>
Shape<S> Triangle::shape(const S& heap) const {
  // A mass below zero is a rounding of an empty box.
  const S area = core::select_above(
      heap, 0.0, [&] { return S(heap / mass_per_area()); }, [] { return S(0.0); });
  auto shape = shape_of_area(frame_, parameters_.box.length, area);
  if (!(core::value_of(shape.apex_z) < parameters_.box.height))
    throw core::InadmissibleState("the heap's apex reaches the inlet");
  return shape;
}
template Shape<double> Triangle::shape(const double&) const;
template Shape<core::Dual<1>> Triangle::shape(const core::Dual<1>&) const;

Context Triangle::context(double t, double heap) const {
  using Dual = core::Dual<1>;
  const auto& box = parameters_.box;
  const auto shape = this->shape(Dual::input(heap, 0));
  // The face leans by the base's tilt and its own rise over the base. Half the apex height lies below its middle, less normal to it.
  const double base = std::tan(box.tilt);
  const Dual tan_zeta = (base + shape.rise) / (1.0 - base * shape.rise);
  const Dual thickness = 0.5 * shape.apex_z / sqrt(1.0 + shape.rise * shape.rise);
  const auto flow = outflow(parameters_.channel, tan_zeta.value, thickness.value);
  return {experiment::inflow_rate(parameters_.inflow, t), flow.rate,
          flow.by_tangent * tan_zeta.slope[0] + flow.by_thickness * thickness.slope[0]};
}

void Triangle::initial_state(double t, std::span<double> y, std::span<double> yp) const {
  std::fill(y.begin(), y.end(), 0.0);
  yp[mass] = yp[mass_in] = experiment::inflow_rate(parameters_.inflow, t);
  yp[mass_right] = 0.0;
}

void Triangle::residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const {
  operator_->residual(context(t, y[mass]), y, yp, r);
}

void Triangle::jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                        std::span<double> values) const {
  operator_->jacobian(context(t, y[mass]), y, yp, c_j, values);
}

std::string Triangle::describe(Index row) const {
  static constexpr std::array words{"mass of the heap", "mass poured in", "mass gone over the right end"};
  return words.at(row);
}

std::vector<double> Triangle::breakpoints() const { return experiment::breakpoints(parameters_.inflow); }

}  // namespace talus::triangle
