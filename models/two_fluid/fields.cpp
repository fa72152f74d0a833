#include "two_fluid/fields.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "core/staggered_fields.hpp"
#include "diagnostics/flow_shares.hpp"
#include "diagnostics/heap_shape.hpp"
#include "two_fluid/cell_state.hpp"

namespace talus::two_fluid {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// One evaluation: the state, and its cells and columns once for all fields.
struct View {
  const TwoFluid& system;
  const core::Snapshot& snapshot;
  std::vector<CellState> cells;  ///< shape (n_layers, n_columns)
  std::vector<double> H;
  std::optional<diagnostics::Face> face;
  diagnostics::Apex apex{0, nothing, nothing};
  diagnostics::FlowShares shares;

  [[nodiscard]] const grid::Rectilinear& grid() const { return system.mesh().grid(); }
  [[nodiscard]] int nx() const { return grid().n_columns(); }
  [[nodiscard]] int nz() const { return grid().n_layers(); }
  [[nodiscard]] double x_centre(int i) const { return grid().x_centre(i); }
  [[nodiscard]] double x_face(int f) const { return grid().x_nodes[f]; }
  [[nodiscard]] double z_centre(int, int k) const { return grid().z_centre(k); }
  [[nodiscard]] double z_node(int, int k) const { return grid().z_nodes[k]; }
  [[nodiscard]] double read(Index index) const { return fv::read(snapshot.y, index); }
  /// A velocity, where there is one.
  [[nodiscard]] double velocity(Index index, bool exists) const { return exists ? read(index) : nothing; }
  [[nodiscard]] double rate(Index index) const { return fv::read(snapshot.yp, index); }
  [[nodiscard]] const CellState& cell(int i, int k) const { return cells[std::size_t(k) * grid().n_columns() + i]; }
  [[nodiscard]] double area(int i, int k) const { return grid().dx(i) * grid().dz(k); }
  /// `value` of each cell times its area, times what a unit area of grains weighs [kg].
  [[nodiscard]] double mass(const std::function<double(const CellState&)>& value) const {
    double sum = 0.0;
    for (const auto [i, k] : system.mesh().cells()) sum += area(i, k) * value(cell(i, k));
    return sum * system.parameters().grains.rho() * system.parameters().box.gap;
  }
};

/// Flowing are cells of grains faster than 1 % of the fastest one of their column.
diagnostics::FlowShares shares_of(const View& v) {
  constexpr double slowest = 0.01;
  std::vector<diagnostics::FlowCell> cells;
  for (int i = 0; i < v.grid().n_columns(); ++i) {
    const auto speed = [&](int k) {
      return v.cell(i, k).phi > dense ? std::hypot(v.cell(i, k).u, v.cell(i, k).w) : 0.0;
    };
    double fastest = 0.0;
    for (int k = 0; k < v.grid().n_layers(); ++k) fastest = std::max(fastest, speed(k));
    for (int k = 0; k < v.grid().n_layers(); ++k) {
      const auto& cell = v.cell(i, k);
      if (speed(k) > slowest * fastest) cells.push_back({cell.I, cell.flow_class, v.area(i, k), speed(k)});
    }
  }
  return diagnostics::flow_shares(v.system.parameters().law, cells);
}

View make_view(const TwoFluid& system, const core::Snapshot& snapshot) {
  View v{system, snapshot, {}, {}, {}, {0, nothing, nothing}, {}};
  const Context context = system.context(snapshot.t);
  const auto& g = v.grid();
  for (int k = 0; k < g.n_layers(); ++k)
    for (int i = 0; i < g.n_columns(); ++i) v.cells.push_back(cell_state(system, context, snapshot.y, i, k));
  for (int i = 0; i < g.n_columns(); ++i) v.H.push_back(heap_height(system, snapshot.y, i));
  if (g.n_columns() >= 3 && !g.periodic) {
    std::vector<double> x;
    for (int i = 0; i < g.n_columns(); ++i) x.push_back(g.x_centre(i));
    const diagnostics::Surface surface{g.dx(0), system.parameters().box.tilt, v.H, x};
    v.apex = diagnostics::apex(surface);
    v.face = diagnostics::right_face(surface);
  }
  v.shares = shares_of(v);
  return v;
}

using Fields = core::StaggeredFields<View>;
using Entry = Fields::Entry;
using Fill = Fields::Fill;

constexpr auto over = &Fields::over;

std::vector<Entry> cell_fields() {
  const auto field = [](const char* name, const char* unit, const char* long_name,
                        std::function<double(const CellState&)> value) {
    return Fields::cell_field(name, unit, long_name,
                              over(false, 0, false, [=](const View& v, int i, int k) { return value(v.cell(i, k)); }));
  };
  using C = CellState;
  std::vector<Entry> all{
      field("phi", "1", "volume fraction of the grains", [](const C& s) { return s.phi; }),
      field("u_centre", "m s-1", "velocity down the base, in the cell's middle", [](const C& s) { return s.u; }),
      field("w_centre", "m s-1", "velocity normal to the base, in the cell's middle", [](const C& s) { return s.w; }),
      field("speed", "m s-1", "speed of the mixture", [](const C& s) { return std::hypot(s.u, s.w); }),
      field("pressure", "Pa", "pressure over that of still air", [](const C& s) { return s.p; }),
      field("strain_rate", "s-1", "second invariant of the strain rate, D_norm (3.13)",
            [](const C& s) { return s.D_norm; }),
      field("inertial_number", "1", "inertial number I (3.15) of the grains, as regularised",
            [](const C& s) { return s.I; }),
      field("friction", "1", "internal friction mu(I) of the grains", [](const C& s) { return s.mu; }),
      field("viscosity", "Pa s", "granular viscosity eta (3.17), as regularised", [](const C& s) { return s.eta; }),
      field("mixture_viscosity", "Pa s", "viscosity of the mixture of grains and air (5.7)",
            [](const C& s) { return s.eta_mixture; }),
      field("cap_active", "1", "1 where the viscosity cap takes away more than half, in cells of grains",
            [](const C& s) { return s.capped ? 1.0 : 0.0; }),
      field("wellposed_C", "1", "C of (3.18): well-posed where it is not positive", [](const C& s) { return s.C; }),
      field("wellposed_q", "1", "mu - I mu'/2: the pressure equation is elliptic where it is below 1",
            [](const C& s) { return s.q; }),
      field("wellposed_nu", "1", "I mu'/mu: where it is above 1/2, C > 0 is not growth",
            [](const C& s) { return s.nu; }),
      field("growth_per_k2", "m2 s-1",
            "largest growth rate of short waves over the square of their wave number, by frozen coefficients",
            [](const C& s) { return s.growth_per_k2; })};
  auto classes = field("wellposed_class", "1", "",
                       [](const C& s) { return s.phi > dense ? static_cast<double>(s.flow_class) : nothing; });
  classes.variable.long_name = "what becomes of short waves: " + diagnostics::flow_class_legend();
  classes.variable.flags = diagnostics::flow_class_flags();
  all.push_back(std::move(classes));
  return all;
}

std::vector<Entry> native_fields() {
  const auto native = &Fields::velocity;
  return {native("u", {"layer", "face"}, "velocity down the base, at the faces of columns", "edge1",
                 over(true, 0, false,
                      [](const View& v, int f, int k) {
                        return v.velocity(v.system.unknowns().u(f, k), v.system.mesh().has_face(f, k));
                      })),
          native("w", {"interface", "column"}, "velocity normal to the base, on the interfaces of layers", "edge2",
                 over(false, 1, false, [](const View& v, int i, int k) {
                   const auto& mesh = v.system.mesh();
                   const bool exists = k == 0 ? mesh.has_cell(i, 0) : mesh.has_interface(i, k);
                   return v.velocity(v.system.unknowns().w(i, k), exists);
                 }))};
}

std::vector<Entry> lines() {
  return {{{"height",
            {"column"},
            "m",
            "thickness of the grains on the base, up to the first cell that they do not fill half",
            core::Storage::double_precision,
            false,
            {{"coordinates", "x"}}},
           [](const View& v, std::vector<double>& out) { out = v.H; }}};
}

std::vector<Entry> numbers(double first_mass) {
  const auto one = &Fields::scalar;
  const auto of = [](Index (Unknowns::*index)() const) {
    return [index](const View& v) { return v.read((v.system.unknowns().*index)()); };
  };
  const auto rate_of = [](Index (Unknowns::*index)() const) {
    return [index](const View& v) { return v.rate((v.system.unknowns().*index)()); };
  };
  const auto stored = [](const View& v) { return v.mass([](const CellState& s) { return s.phi; }); };
  const auto extreme = [](double sign) {
    return [sign](const View& v) {
      double most = -std::numeric_limits<double>::infinity();
      for (const auto [i, k] : v.system.mesh().cells()) most = std::max(most, sign * v.cell(i, k).phi);
      return sign * most;
    };
  };
  constexpr double to_degrees = 180.0 / std::numbers::pi;
  return {
      one("mass_stored", "kg", "mass of grains in the box, in the air included", stored),
      one("mass_airborne", "kg", "mass of the grains in cells that they do not fill half",
          [](const View& v) { return v.mass([](const CellState& s) { return s.phi > dense ? 0.0 : s.phi; }); }),
      one("mass_excess", "kg", "mass by which grains overfill cells, and that which cells lack below empty",
          [](const View& v) {
            return v.mass([](const CellState& s) { return std::max({s.phi - 1.0, -s.phi, 0.0}); });
          }),
      {{"n_cells", {}, "1", "cells that have unknowns", core::Storage::double_precision, true, {}},
       Fields::number([](const View& v) { return static_cast<double>(v.system.mesh().cells().size()); })},
      one("phi_min", "1", "least volume fraction of the grains", extreme(-1.0)),
      one("phi_max", "1", "largest volume fraction of the grains", extreme(1.0)),
      one("mass_inflow", "kg", "mass poured in since the start", of(&Unknowns::mass_in)),
      one("mass_outflow_left", "kg", "mass gone over the left end since the start", of(&Unknowns::mass_left)),
      one("mass_outflow_right", "kg", "mass gone over the right end since the start", of(&Unknowns::mass_right)),
      one("mass_outflow_top", "kg", "mass gone through the top and the edge of the cells since the start",
          of(&Unknowns::mass_top)),
      one("mass_error", "kg", "stored mass less what it was at the start, less inflow, plus outflow",
          [=](const View& v) {
            const auto& at = v.system.unknowns();
            return stored(v) - first_mass - v.read(at.mass_in()) + v.read(at.mass_left()) + v.read(at.mass_right()) +
                   v.read(at.mass_top());
          }),
      one("inflow_rate", "kg s-1", "mass poured in per second", rate_of(&Unknowns::mass_in)),
      one("outflow_rate_left", "kg s-1", "mass leaving over the left end per second", rate_of(&Unknowns::mass_left)),
      one("outflow_rate_right", "kg s-1", "mass leaving over the right end per second", rate_of(&Unknowns::mass_right)),
      one("jet_heap_height", "m",
          "height of the heap under the jet, H of (5.12); where grains fall freely the mean over their lines",
          [](const View& v) {
            const auto& at = v.system.unknowns();
            double sum = 0.0;
            for (int line = 0; line < at.n_heaps(); ++line) sum += v.read(at.heap(line));
            return at.n_heaps() > 0 ? sum / at.n_heaps() : 0.0;
          }),
      one("heap_angle", "degree", "slope of the straight right face against the horizontal",
          [=](const View& v) { return v.face ? v.face->angle * to_degrees : nothing; }),
      one("apex_x", "m", "distance down the base to the thickest point", [](const View& v) { return v.apex.x; }),
      one("apex_z", "m", "thickness at the thickest point", [](const View& v) { return v.apex.H; })};
}

std::vector<Entry> shares() {
  return Fields::shares(diagnostics::share_numbers(), [](const View& v) { return v.shares; });
}

std::vector<Entry> entries(const TwoFluid& system) {
  const auto& par = system.parameters();
  const double first_mass = par.thickness * par.box.length * par.grains.rho() * par.box.gap;
  std::vector<Entry> all;
  for (auto&& group : {Fields::coordinates(), lines(), cell_fields(), native_fields(), numbers(first_mass), shares()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace

std::vector<std::pair<std::string, std::size_t>> TwoFluidFields::dimensions() const {
  return Fields::dimensions(system_.mesh().grid().n_columns(), system_.mesh().grid().n_layers());
}

std::vector<core::Variable> TwoFluidFields::variables() const { return Fields::variables(entries(system_)); }

void TwoFluidFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  Fields::evaluate(entries(system_), make_view(system_, snapshot), values);
}

}  // namespace talus::two_fluid
