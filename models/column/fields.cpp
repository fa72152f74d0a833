#include "column/fields.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "column/layer_state.hpp"
#include "diagnostics/flow_shares.hpp"

namespace talus::column {
namespace {

/// One evaluation: the state, once for all fields.
struct View {
  const Column& column;
  experiment::Box box;
  std::span<const double> u;
  std::vector<LayerState> layers;
  Forces forces;
  double area_flow;  ///< int u dz [m2/s]
  diagnostics::FlowShares shares;
};

/// Flowing are layers faster than 1 % of the uppermost.
diagnostics::FlowShares shares_of(const Column& column, const std::vector<LayerState>& layers) {
  constexpr double slowest = 0.01;
  std::vector<diagnostics::FlowCell> cells;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const double speed = std::abs(layers[k].u);
    const bool flows = speed > slowest * std::abs(layers.back().u);
    cells.push_back(
        {layers[k].I, layers[k].flow_class, flows ? column.heights().thickness(static_cast<int>(k)) : 0.0, speed});
  }
  return diagnostics::flow_shares(column.parameters().law, cells);
}

View make_view(const Column& column, const core::Snapshot& now) {
  View v{column,
         experiment::box_at(column.parameters().box, column.parameters().motion, now.t),
         now.y,
         layer_states(column, now.t, now.y),
         forces(column, now.t, now.y),
         0.0,
         {}};
  v.shares = shares_of(column, v.layers);
  for (int k = 0; k < column.heights().n_layers(); ++k) v.area_flow += now.y[k] * column.heights().thickness(k);
  return v;
}

struct Entry {
  core::Variable variable;
  std::function<void(const View&, std::vector<double>&)> fill;
};

std::vector<Entry> coordinates() {
  const auto along = [](const char* name, const char* dimension, const char* words, std::vector<double> Heights::*z) {
    return Entry{
        {name, {dimension}, "m", words, core::Storage::double_precision, true, {{"axis", "Z"}, {"positive", "up"}}},
        [z](const View& v, std::vector<double>& out) { out = v.column.heights().*z; }};
  };
  return {
      along("z", "layer", "height of the layer's middle, normal to the base", &Heights::centre),
      along("z_interface", "interface", "height of the interfaces of layers, normal to the base", &Heights::interface)};
}

Entry profile(const char* name, const char* unit, const char* long_name,
              std::function<double(const LayerState&)> value) {
  return {{name, {"layer"}, unit, long_name, core::Storage::double_precision, false, {{"coordinates", "z"}}},
          [value = std::move(value)](const View& v, std::vector<double>& out) {
            out.clear();
            for (const auto& layer : v.layers) out.push_back(value(layer));
          }};
}

/// A number for each class, as diagnostics::FlowClass counts them.
Entry flow_class_profile() {
  auto entry =
      profile("wellposed_class", "1", "", [](const LayerState& s) { return static_cast<double>(s.flow_class); });
  entry.variable.long_name = "what becomes of short waves: " + diagnostics::flow_class_legend();
  entry.variable.flags = diagnostics::flow_class_flags();
  return entry;
}

std::vector<Entry> profiles() {
  using L = LayerState;
  return {
      profile("u", "m s-1", "velocity down the slope, in the layer's middle", [](const L& s) { return s.u; }),
      profile("speed", "m s-1", "speed of the grains", [](const L& s) { return std::abs(s.u); }),
      profile("pressure", "Pa", "pressure, lithostatic", [](const L& s) { return s.p; }),
      profile("strain_rate", "s-1", "second invariant of the strain rate, D_norm (3.13)",
              [](const L& s) { return s.D_norm; }),
      profile("inertial_number", "1", "inertial number I (3.15), as regularised", [](const L& s) { return s.I; }),
      profile("friction", "1", "internal friction mu(I)", [](const L& s) { return s.mu; }),
      profile("viscosity", "Pa s", "granular viscosity eta (3.17), as regularised", [](const L& s) { return s.eta; }),
      profile("wellposed_C", "1", "C of (3.18): well-posed where it is not positive", [](const L& s) { return s.C; }),
      profile("wellposed_q", "1", "mu - I mu'/2: the pressure equation is elliptic where it is below 1",
              [](const L& s) { return s.q; }),
      profile("wellposed_nu", "1", "I mu'/mu: where it is above 1/2, C > 0 is not growth",
              [](const L& s) { return s.nu; }),
      profile("growth_per_k2", "m2 s-1",
              "largest growth rate of short waves over the square of their wave number, by frozen coefficients",
              [](const L& s) { return s.growth_per_k2; }),
      flow_class_profile(),
      profile("cap_active", "1", "1 where the viscosity cap takes away more than half",
              [](const L& s) { return s.capped ? 1.0 : 0.0; }),
      profile("rate_floor_active", "1", "1 where the floor under the strain rate is above the strain rate",
              [](const L& s) { return s.floored ? 1.0 : 0.0; }),
      profile("pressure_shift", "Pa", "what p_0 adds to the pressure in viscosity and friction",
              [](const L& s) { return s.pressure_shift; }),
      profile("wall_mobilisation", "1", "share of the side walls' friction that is turned on, tanh(|u|/u_c)",
              [](const L& s) { return s.wall_mobilisation; })};
}

Entry number(const char* name, const char* unit, const char* long_name, std::function<double(const View&)> value) {
  return {{name, {}, unit, long_name, core::Storage::double_precision, false, {}},
          [value = std::move(value)](const View& v, std::vector<double>& out) { out.assign(1, value(v)); }};
}

std::vector<Entry> numbers() {
  constexpr double to_degrees = 180.0 / std::numbers::pi;
  return {number("surface_speed", "m s-1", "velocity down the slope on the surface",
                 [](const View& v) { return surface_speed(v.column, v.u); }),
          number("mean_speed", "m s-1", "velocity down the slope, mean over the thickness",
                 [](const View& v) { return v.area_flow / v.column.heights().surface(); }),
          number("mass_flow", "kg s-1", "mass flow Q down the slope between the side walls",
                 [](const View& v) { return v.column.parameters().grains.rho() * v.box.gap * v.area_flow; }),
          number("flow_per_width", "m2 s-1", "volume flow of the grains down the slope, a unit width",
                 [](const View& v) { return v.area_flow; }),
          number("slope", "degree", "slope of the layer against the horizontal",
                 [](const View& v) { return experiment::base_angle(v.box) * to_degrees; }),
          number("gap", "m", "distance of the side walls", [](const View& v) { return v.box.gap; }),
          number("weight", "Pa", "weight of the layer down the slope, a unit area of the base",
                 [](const View& v) { return v.forces.weight; }),
          number("wall_friction", "Pa", "force of the side walls on the layer, a unit area of the base",
                 [](const View& v) { return v.forces.wall_friction; }),
          number("base_stress", "Pa", "shear stress of the base on the layer",
                 [](const View& v) { return v.forces.base_stress; }),
          number("momentum_rate", "Pa", "rate of the layer's momentum, a unit area of the base, summed over its layers",
                 [](const View& v) { return v.forces.momentum_rate; }),
          number("momentum_error", "Pa", "weight, wall friction and base stress less the rate of momentum",
                 [](const View& v) { return v.forces.imbalance(); })};
}

std::vector<Entry> shares() {
  std::vector<Entry> all;
  for (const auto& share : diagnostics::share_numbers())
    all.push_back({{share.name, {}, "1", share.long_name, core::Storage::double_precision, false, {}},
                   [value = share.value](const View& v, std::vector<double>& out) { out.assign(1, value(v.shares)); }});
  return all;
}

std::vector<Entry> entries() {
  std::vector<Entry> all;
  for (auto&& group : {coordinates(), profiles(), numbers(), shares()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace

std::vector<std::pair<std::string, std::size_t>> ColumnFields::dimensions() const {
  const auto n = static_cast<std::size_t>(column_.heights().n_layers());
  return {{"layer", n}, {"interface", n + 1}};
}

std::vector<core::Variable> ColumnFields::variables() const {
  std::vector<core::Variable> out;
  for (auto& entry : entries()) out.push_back(std::move(entry.variable));
  return out;
}

void ColumnFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  const auto all = entries();
  const View view = make_view(column_, snapshot);
  values.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].fill(view, values[i]);
}

}  // namespace talus::column
