#include "layer/fields.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "core/both.hpp"
#include "core/staggered_fields.hpp"
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
  [[nodiscard]] double x_centre(int i) const { return layer.columns().x_centre(i); }
  [[nodiscard]] double x_face(int f) const { return layer.columns().x_face(f); }
  [[nodiscard]] double z_centre(int i, int k) const {
    return 0.5 * (z(i, k) + z(i, k + 1)) + layer.parameters().box.base_slope * x_centre(i);
  }
  [[nodiscard]] double z_node(int f, int k) const {
    return 0.5 * (z(f - 1, k) + z(f, k)) + layer.parameters().box.base_slope * x_face(f);
  }
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
  v.cells.resize(std::size_t(v.nx()) * v.nz());
  const auto fill_layers = [&](int from, int to) {
    for (int k = from; k < to; ++k)
      for (int i = 0; i < v.nx(); ++i)
        v.cells[std::size_t(k) * v.nx() + i] = cell_state(layer, v.context, snapshot.y, i, k);
  };
  core::both(
      v.cells.size() >= fv::Operator<Context>::least_for_threads, [&] { fill_layers(0, v.nz() / 2); },
      [&] { fill_layers(v.nz() / 2, v.nz()); });
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

using Fields = core::StaggeredFields<View>;
using Entry = Fields::Entry;
using Fill = Fields::Fill;

constexpr auto over = &Fields::over;

Fill cells(double CellState::*member) {
  return over(false, 0, false,
              [=](const View& v, int i, int k) { return v.cells[std::size_t(k) * v.nx() + i].*member; });
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
  const auto field = &Fields::cell_field;
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
  const auto native = &Fields::velocity;
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
    return Fields::scalar(name, "m s-1", long_name, [part](const View& v) { return v.waves.*part; });
  };
  return {one("disturbance_speed", "root mean square of u in the waves along x that were disturbed at the start",
              &WaveParts::disturbed),
          one("other_waves_speed", "root mean square of u in all other waves along x", &WaveParts::others)};
}

std::vector<Entry> numbers(double first_mass) {
  const auto one = &Fields::scalar;
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
  return Fields::shares(diagnostics::share_numbers(), [](const View& v) { return v.shares; });
}

std::vector<Entry> entries(const Layer& layer) {
  std::vector<Entry> all;
  const double first_mass = layer.parameters().initial.thickness * layer.parameters().box.length *
                            layer.parameters().grains.rho() * layer.parameters().box.gap;
  for (auto&& group : {Fields::coordinates(), lines(), cell_fields(), native_fields(), numbers(first_mass), shares()})
    all.insert(all.end(), group.begin(), group.end());
  if (layer.parameters().initial.disturbance)
    for (auto&& entry : wave_numbers()) all.push_back(std::move(entry));
  return all;
}

}  // namespace

std::vector<std::pair<std::string, std::size_t>> LayerFields::dimensions() const {
  return Fields::dimensions(layer_.columns().n_columns, layer_.columns().n_layers);
}

std::vector<core::Variable> LayerFields::variables() const { return Fields::variables(entries(layer_)); }

void LayerFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  Fields::evaluate(entries(layer_), make_view(layer_, snapshot), values);
}

}  // namespace talus::layer
