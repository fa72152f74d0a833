#include "layer/fields.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "diagnostics/heap_shape.hpp"
#include "layer/cell_state.hpp"
#include "layer/film.hpp"
#include "layer/flow_shares.hpp"
#include "layer/jet.hpp"

namespace talus::layer {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// One evaluation: the state, its grid, and its cells once for all fields.
struct View {
  const Layer& layer;
  const core::Snapshot& snapshot;
  const Context& context;
  std::vector<CellState> cells;  ///< shape (n_layers, n_columns)
  std::vector<double> H;
  std::optional<diagnostics::Face> face;
  diagnostics::Apex apex;
  double roughness;
  diagnostics::FlowShares shares;
  WaveParts waves{nothing, nothing};

  [[nodiscard]] double read(Index index) const { return index < 0 ? 0.0 : snapshot.y[index]; }
  [[nodiscard]] double rate(Index index) const { return index < 0 ? 0.0 : snapshot.yp[index]; }
  [[nodiscard]] int nx() const { return layer.columns().n_columns; }
  [[nodiscard]] int nz() const { return layer.columns().n_layers; }
  [[nodiscard]] double z(int i, int k) const { return context.z[context.at(i, k)]; }
  /// [kg/s]
  [[nodiscard]] double mass_flow() const {
    const auto& at = layer.unknowns();
    double sum = 0.0;
    for (int f = 0; f <= nx(); ++f) {
      for (int k = 0; k < nz(); ++k)
        sum += read(at.u(f, k)) * 0.5 * (z(f - 1, k + 1) - z(f - 1, k) + z(f, k + 1) - z(f, k));
    }
    return sum / (nx() + 1) * layer.parameters().grains.rho() * layer.parameters().box.gap;
  }
  [[nodiscard]] double mass_stored() const {
    double sum = 0.0;
    for (const double h : H) sum += h;
    return sum * layer.columns().dx() * layer.parameters().grains.rho() * layer.parameters().box.gap;
  }
};

/// Largest second difference of H over the straight right face, as a share of the top layer's thickness there.
double face_roughness(std::span<const double> H, std::span<const double> top,
                      const std::optional<diagnostics::Face>& face) {
  if (!face) return nothing;
  double largest = 0.0;
  for (int i = face->first + 1; i < face->last; ++i)
    largest = std::max(largest, std::abs(H[i - 1] - 2.0 * H[i] + H[i + 1]) / top[i]);
  return largest;
}

View make_view(const Layer& layer, const core::Snapshot& snapshot) {
  View v{layer, snapshot, layer.context(snapshot.t, snapshot.y), {}, {}, {}, {0, nothing, nothing}, nothing, {}};
  for (int k = 0; k < v.nz(); ++k)
    for (int i = 0; i < v.nx(); ++i) v.cells.push_back(cell_state(layer, v.context, snapshot.y, i, k));
  std::vector<double> top;
  for (int i = 0; i < v.nx(); ++i) {
    v.H.push_back(snapshot.y[layer.unknowns().H(i)]);
    top.push_back(v.z(i, v.nz()) - v.z(i, v.nz() - 1));
  }
  if (v.nx() >= 3 && !layer.columns().periodic) {
    const diagnostics::Surface surface{layer.columns().dx(), layer.parameters().box.tilt, v.H};
    v.apex = diagnostics::apex(surface);
    v.face = diagnostics::right_face(surface);
    v.roughness = face_roughness(v.H, top, v.face);
  }
  v.shares = flow_shares(layer, v.context, v.H, v.cells);
  if (const auto& disturbance = layer.parameters().initial.disturbance) {
    std::vector<double> u;
    for (int k = 0; k < v.nz(); ++k)
      for (int f = 0; f < v.nx(); ++f) u.push_back(v.read(layer.unknowns().u(f, k)));
    v.waves = wave_parts(*disturbance, u, v.nx());
  }
  return v;
}

using Dimensions = std::vector<std::string>;
using Fill = std::function<void(const View&, std::vector<double>&)>;

struct Entry {
  core::Variable variable;
  Fill fill;
};

/// A value a column, a face, a cell, ... in row-major order.
Fill over(bool faces, int rows_beyond_layers, bool flat, std::function<double(const View&, int, int)> value) {
  return [=](const View& v, std::vector<double>& out) {
    const int n = v.nx() + (faces ? 1 : 0), rows = flat ? 1 : v.nz() + rows_beyond_layers;
    out.clear();
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < n; ++i) out.push_back(value(v, i, k));
  };
}
Fill cells(double CellState::*member) {
  return over(false, 0, false,
              [=](const View& v, int i, int k) { return v.cells[std::size_t(k) * v.nx() + i].*member; });
}
Fill number(std::function<double(const View&)> value) {
  return [=](const View& v, std::vector<double>& out) { out.assign(1, value(v)); };
}

std::vector<Entry> coordinates() {
  const auto as_double = core::Storage::double_precision;
  const std::map<std::string, std::string> sgrid{
      {"cf_role", "grid_topology"},
      {"topology_dimension", "2"},
      {"node_dimensions", "face interface"},
      {"face_dimensions", "column: face (padding: none) layer: interface (padding: none)"},
      {"edge1_dimensions", "face layer: interface (padding: none)"},
      {"edge2_dimensions", "interface column: face (padding: none)"},
      {"node_coordinates", "x_face z_node"},
      {"face_coordinates", "x z"}};
  return {
      {{"grid", {}, "1", "staggered grid of columns and layers", as_double, true, sgrid},
       number([](const View&) { return 0.0; })},
      {{"x", {"column"}, "m", "distance down the base to the middle of the column", as_double, true, {{"axis", "X"}}},
       over(false, 0, true, [](const View& v, int i, int) { return v.layer.columns().x_centre(i); })},
      {{"x_face", {"face"}, "m", "distance down the base to the face", as_double, true, {}},
       over(true, 0, true, [](const View& v, int i, int) { return v.layer.columns().x_face(i); })},
      {{"z",
        {"layer", "column"},
        "m",
        "height of the cell's middle, normal to the base",
        as_double,
        false,
        {{"axis", "Z"}, {"positive", "up"}}},
       over(false, 0, false,
            [](const View& v, int i, int k) {
              return 0.5 * (v.z(i, k) + v.z(i, k + 1)) +
                     v.layer.parameters().box.base_slope * v.layer.columns().x_centre(i);
            })},
      {{"z_node", {"interface", "face"}, "m", "height of the cell's corner, normal to the base", as_double, false, {}},
       over(true, 1, false, [](const View& v, int f, int k) {
         return 0.5 * (v.z(f - 1, k) + v.z(f, k)) + v.layer.parameters().box.base_slope * v.layer.columns().x_face(f);
       })}};
}

/// A number for each class, as diagnostics::FlowClass counts them.
Entry flow_class_field() {
  return {{"wellposed_class",
           {"layer", "column"},
           "1",
           "what becomes of short waves: " + diagnostics::flow_class_legend(),
           core::Storage::single_precision,
           false,
           {{"coordinates", "x z"}, {"grid", "grid"}, {"location", "face"}},
           diagnostics::flow_class_flags()},
          over(false, 0, false, [](const View& v, int i, int k) {
            return static_cast<double>(class_of(v.cells[std::size_t(k) * v.nx() + i]));
          })};
}

std::vector<Entry> cell_fields() {
  const auto field = [](const char* name, const char* unit, const char* long_name, Fill fill) {
    return Entry{{name,
                  {"layer", "column"},
                  unit,
                  long_name,
                  core::Storage::single_precision,
                  false,
                  {{"coordinates", "x z"}, {"grid", "grid"}, {"location", "face"}}},
                 std::move(fill)};
  };
  return {
      field("u_centre", "m s-1", "velocity down the base, in the cell's middle", cells(&CellState::u)),
      field("w_centre", "m s-1", "velocity normal to the base, in the cell's middle", cells(&CellState::w)),
      field("speed", "m s-1", "speed of the grains",
            over(false, 0, false,
                 [](const View& v, int i, int k) {
                   const auto& cell = v.cells[std::size_t(k) * v.nx() + i];
                   return std::hypot(cell.u, cell.w);
                 })),
      field("pressure", "Pa", "pressure", cells(&CellState::p)),
      field("strain_rate", "s-1", "second invariant of the strain rate, D_norm (3.13)", cells(&CellState::D_norm)),
      field("inertial_number", "1", "inertial number I (3.15), as regularised", cells(&CellState::I)),
      field("friction", "1", "internal friction mu(I)", cells(&CellState::mu)),
      field("viscosity", "Pa s", "granular viscosity eta (3.17), as regularised", cells(&CellState::eta)),
      field("cap_active", "1", "1 where the viscosity cap takes away more than half",
            over(false, 0, false,
                 [](const View& v, int i, int k) { return v.cells[std::size_t(k) * v.nx() + i].capped ? 1.0 : 0.0; })),
      field("wellposed_C", "1", "C of (3.18): well-posed where it is not positive", cells(&CellState::C)),
      field("wellposed_q", "1", "mu - I mu'/2: the pressure equation is elliptic where it is below 1",
            cells(&CellState::q)),
      field("wellposed_nu", "1", "I mu'/mu: where it is above 1/2, C > 0 is not growth", cells(&CellState::nu)),
      field("growth_per_k2", "m2 s-1",
            "largest growth rate of short waves over the square of their wave number, by frozen coefficients",
            cells(&CellState::growth_per_k2)),
      flow_class_field()};
}

std::vector<Entry> native_fields() {
  const auto native = [](const char* name, Dimensions dimensions, const char* long_name, const char* location,
                         Fill fill) {
    return Entry{{name,
                  std::move(dimensions),
                  "m s-1",
                  long_name,
                  core::Storage::single_precision,
                  false,
                  {{"grid", "grid"}, {"location", location}}},
                 std::move(fill)};
  };
  return {
      native("u", {"layer", "face"}, "velocity down the base, at the faces of columns", "edge1",
             over(true, 0, false, [](const View& v, int f, int k) { return v.read(v.layer.unknowns().u(f, k)); })),
      native(
          "w", {"interface", "column"}, "velocity normal to the base, on the interfaces of layers", "edge2",
          over(false, 1, false,
               [](const View& v, int i, int k) { return vertical_velocity(v.layer, v.context, v.snapshot.y, i, k); })),
      native(
          "omega", {"interface", "column"}, "volume flux through the interfaces of layers, w - u dz/dx", "edge2",
          over(false, 1, false, [](const View& v, int i, int k) { return v.read(v.layer.unknowns().omega(i, k)); }))};
}

std::vector<Entry> lines() {
  const auto as_double = core::Storage::double_precision;
  return {{{"height",
            {"column"},
            "m",
            "thickness of the grains above the base, H",
            as_double,
            false,
            {{"coordinates", "x"}}},
           [](const View& v, std::vector<double>& out) { out = v.H; }},
          {{"surface_speed",
            {"column"},
            "m s-1",
            "speed of the grains in the uppermost layer",
            core::Storage::single_precision,
            false,
            {{"coordinates", "x"}}},
           over(false, 0, true, [](const View& v, int i, int) {
             const auto& cell = v.cells[std::size_t(v.nz() - 1) * v.nx() + i];
             return std::hypot(cell.u, cell.w);
           })}};
}

/// Flow of mass over the right (sign +1) or the left (-1) end [kg/s].
double leaving(const View& v, double sign) {
  const auto& at = v.layer.unknowns();
  return v.rate(sign > 0.0 ? at.mass_right() : at.mass_left());
}

/// Of a layer that was disturbed at the start.
std::vector<Entry> wave_numbers() {
  const auto one = [](const char* name, const char* long_name, double WaveParts::*part) {
    return Entry{{name, {}, "m s-1", long_name, core::Storage::double_precision, false, {}},
                 number([part](const View& v) { return v.waves.*part; })};
  };
  return {one("disturbance_speed", "root mean square of u in the waves along x that were disturbed at the start",
              &WaveParts::disturbed),
          one("other_waves_speed", "root mean square of u in all other waves along x", &WaveParts::others)};
}

std::vector<Entry> numbers(double first_mass) {
  const auto one = [](const char* name, const char* unit, const char* long_name,
                      std::function<double(const View&)> value) {
    return Entry{{name, {}, unit, long_name, core::Storage::double_precision, false, {}}, number(std::move(value))};
  };
  const auto mass = [](Index (Unknowns::*index)() const) {
    return [index](const View& v) { return v.read((v.layer.unknowns().*index)()); };
  };
  const double to_degrees = 180.0 / std::numbers::pi;
  return {one("mass_stored", "kg", "mass in the box, film included", [](const View& v) { return v.mass_stored(); }),
          one("mass_inflow", "kg", "mass poured in since the start", mass(&Unknowns::mass_in)),
          one("mass_outflow_left", "kg", "mass gone over the left end since the start", mass(&Unknowns::mass_left)),
          one("mass_outflow_right", "kg", "mass gone over the right end since the start", mass(&Unknowns::mass_right)),
          one("mass_error", "kg", "stored mass less what it was at the start, less inflow, plus outflow",
              [first_mass](const View& v) {
                const auto& at = v.layer.unknowns();
                return v.mass_stored() - first_mass - v.read(at.mass_in()) + v.read(at.mass_left()) +
                       v.read(at.mass_right());
              }),
          one("inflow_rate", "kg s-1", "mass poured in per second",
              [](const View& v) { return experiment::inflow_rate(v.layer.parameters().inflow, v.snapshot.t); }),
          one("outflow_rate_left", "kg s-1", "mass leaving over the left end per second",
              [](const View& v) { return leaving(v, -1.0); }),
          one("outflow_rate_right", "kg s-1", "mass leaving over the right end per second",
              [](const View& v) { return leaving(v, 1.0); }),
          one("heap_angle", "degree", "slope of the straight right face against the horizontal",
              [to_degrees](const View& v) { return v.face ? v.face->angle * to_degrees : nothing; }),
          one("apex_x", "m", "distance down the base to the thickest point", [](const View& v) { return v.apex.x; }),
          one("apex_z", "m", "thickness at the thickest point", [](const View& v) { return v.apex.H; }),
          one("surface_roughness", "1",
              "largest second difference of H over the straight right face, as a share of the top layer",
              [](const View& v) { return v.roughness; }),
          one("mass_flow", "kg s-1", "mass flow down the base, mean over the faces of columns",
              [](const View& v) { return v.mass_flow(); })};
}

std::vector<Entry> shares() {
  std::vector<Entry> all;
  for (const auto& share : diagnostics::share_numbers())
    all.push_back({{share.name, {}, "1", share.long_name, core::Storage::double_precision, false, {}},
                   number([value = share.value](const View& v) { return value(v.shares); })});
  return all;
}

std::vector<Entry> entries(const Layer& layer) {
  std::vector<Entry> all;
  const double first_mass = layer.parameters().initial.thickness * layer.parameters().box.length *
                            layer.parameters().grains.rho() * layer.parameters().box.gap;
  for (auto&& group : {coordinates(), lines(), cell_fields(), native_fields(), numbers(first_mass), shares()})
    all.insert(all.end(), group.begin(), group.end());
  if (layer.parameters().initial.disturbance)
    for (auto&& entry : wave_numbers()) all.push_back(std::move(entry));
  return all;
}

}  // namespace

std::vector<std::pair<std::string, std::size_t>> LayerFields::dimensions() const {
  const std::size_t nx = layer_.columns().n_columns, nz = layer_.columns().n_layers;
  return {{"column", nx}, {"face", nx + 1}, {"layer", nz}, {"interface", nz + 1}};
}

std::vector<core::Variable> LayerFields::variables() const {
  std::vector<core::Variable> out;
  for (auto& entry : entries(layer_)) out.push_back(std::move(entry.variable));
  return out;
}

void LayerFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  const auto all = entries(layer_);
  const View view = make_view(layer_, snapshot);
  values.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].fill(view, values[i]);
}

}  // namespace talus::layer
