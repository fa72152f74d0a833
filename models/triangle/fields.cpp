#include "triangle/fields.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace talus::triangle {
namespace {

/// One evaluation: the state, once for all fields.
struct View {
  const Triangle& triangle;
  std::span<const double> y, yp;
  Shape<double> shape;
  double inflow;  ///< [kg/s]

  [[nodiscard]] double mass_left() const { return triangle.mass_per_area() * shape.cut_off; }
  [[nodiscard]] double mass_stored() const { return y[Triangle::mass] - mass_left(); }
  [[nodiscard]] double slope() const { return triangle.parameters().box.tilt + std::atan(shape.rise); }
};

View make_view(const Triangle& triangle, const core::Snapshot& now) {
  return {triangle, now.y, now.yp, triangle.shape(now.y[Triangle::mass]),
          experiment::inflow_rate(triangle.parameters().inflow, now.t)};
}

struct Entry {
  core::Variable variable;
  std::function<void(const View&, std::vector<double>&)> fill;
};

std::vector<Entry> lines() {
  // A value at each x = (first + i) dx, i = 0, 1, ... up to the right end.
  const auto at = [](double first, std::function<double(const View&, double x)> value) {
    return [=](const View& v, std::vector<double>& out) {
      const auto& par = v.triangle.parameters();
      out.clear();
      for (double i = first; i <= par.columns; ++i) out.push_back(value(v, i * par.box.length / par.columns));
    };
  };
  const auto itself = [](const View&, double x) { return x; };
  const auto as_double = core::Storage::double_precision;
  return {
      {{"x", {"column"}, "m", "distance down the base to the middle of the column", as_double, true, {{"axis", "X"}}},
       at(0.5, itself)},
      {{"x_face", {"face"}, "m", "distance down the base to the face", as_double, true, {}}, at(0.0, itself)},
      {{"height",
        {"column"},
        "m",
        "thickness of the grains above the base, H",
        as_double,
        false,
        {{"coordinates", "x"}}},
       at(0.5, [](const View& v, double x) { return height_at(v.shape, v.triangle.parameters().box.length, x); })}};
}

Entry number(const char* name, const char* unit, const char* long_name, std::function<double(const View&)> value) {
  return {{name, {}, unit, long_name, core::Storage::double_precision, false, {}},
          [value = std::move(value)](const View& v, std::vector<double>& out) { out.assign(1, value(v)); }};
}

/// d(mass over the left end)/dt [kg/s].
double leaving_left(const View& v) {
  const auto shape = v.triangle.shape(core::Dual<1>::input(v.y[Triangle::mass], 0));
  return v.triangle.mass_per_area() * shape.cut_off.slope[0] * v.yp[Triangle::mass];
}

std::vector<Entry> numbers() {
  constexpr double to_degrees = 180.0 / std::numbers::pi;
  return {
      number("mass_stored", "kg", "mass in the box", [](const View& v) { return v.mass_stored(); }),
      number("mass_inflow", "kg", "mass poured in since the start",
             [](const View& v) { return v.y[Triangle::mass_in]; }),
      number("mass_outflow_left", "kg", "mass gone over the left end since the start",
             [](const View& v) { return v.mass_left(); }),
      number("mass_outflow_right", "kg", "mass gone over the right end since the start",
             [](const View& v) { return v.y[Triangle::mass_right]; }),
      number("mass_error", "kg", "stored mass less inflow, plus outflow",
             [](const View& v) { return v.y[Triangle::mass] - v.y[Triangle::mass_in] + v.y[Triangle::mass_right]; }),
      number("inflow_rate", "kg s-1", "mass poured in per second", [](const View& v) { return v.inflow; }),
      number("outflow_rate_left", "kg s-1", "mass leaving over the left end per second", leaving_left),
      number("outflow_rate_right", "kg s-1", "mass leaving over the right end per second",
             [](const View& v) { return v.yp[Triangle::mass_right]; }),
      number("heap_angle", "degree", "slope of the right face against the horizontal",
             [](const View& v) { return v.slope() * to_degrees; }),
      number("apex_x", "m", "distance down the base to the apex", [](const View& v) { return v.shape.apex_x; }),
      number("apex_z", "m", "height of the apex over the base", [](const View& v) { return v.shape.apex_z; })};
}

std::vector<Entry> entries() {
  auto all = lines();
  std::ranges::move(numbers(), std::back_inserter(all));
  return all;
}

}  // namespace

std::vector<std::pair<std::string, std::size_t>> TriangleFields::dimensions() const {
  const auto n = static_cast<std::size_t>(triangle_.parameters().columns);
  return {{"column", n}, {"face", n + 1}};
}

std::vector<core::Variable> TriangleFields::variables() const {
  std::vector<core::Variable> out;
  for (auto& entry : entries()) out.push_back(std::move(entry.variable));
  return out;
}

void TriangleFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  const auto all = entries();
  const View view = make_view(triangle_, snapshot);
  values.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].fill(view, values[i]);
}

}  // namespace talus::triangle
