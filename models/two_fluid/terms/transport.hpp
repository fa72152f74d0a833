#pragma once

#include "experiment/inflow.hpp"
#include "two_fluid/grain_flux.hpp"
#include "two_fluid/terms/kernel.hpp"

namespace talus::two_fluid {

/// Incompressibility (5.4) and transport of the grains (5.13) through the faces of columns, and what leaves over the ends and edges.
struct TransportAlong : Kernel {
  static constexpr int n_in = 7, n_out = 5;
  enum In { u_, phi_, heap_ = 5, beneath_ = 6 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    const auto phi = row_at_face(f, k);
    in = {at->u(f, k), phi[0], phi[1], phi[2], phi[3], heap_at_face(f, k), beneath_at_face(f, k)};
    const bool inside = mesh->has_cell(f - 1, k) && mesh->has_cell(f, k), end = grid().is_end(f);
    const Index budget = inside ? -1 : (!end ? at->mass_top() : (f == 0 ? at->mass_left() : at->mass_right()));
    out = {at->continuity(f - 1, k), at->continuity(f, k), at->phi(f - 1, k), at->phi(f, k), budget};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const double area = grid().dz(k);
    const Row<S> phi{in.y[phi_], in.y[phi_ + 1], in.y[phi_ + 2], in.y[phi_ + 3]};
    const S volume = area * in.y[u_], grains = area * grain_flux_x(c, f, k, in.y[u_], phi, in.y[beneath_], in.y[heap_]);
    out[0] += volume;
    out[1] -= volume;
    out[2] += grains;
    out[3] -= grains;
    const double outwards = mesh->has_cell(f, k) ? -1.0 : 1.0;
    out[4] -= (outwards * c.grains_across()) * grains;
  }
};

/// The same through the interfaces of layers, the top of the box and edges of the cells included: what is poured in, and what leaves there.
struct TransportUp : Kernel {
  static constexpr int n_in = 6, n_out = 5;
  enum In { w_, phi_, heap_ = 5 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    const auto phi = row_at_interface(i, k);
    in = {at->w(i, k), phi[0], phi[1], phi[2], phi[3], heap_at_interface(i, k)};
    const bool inside = mesh->has_cell(i, k - 1) && mesh->has_cell(i, k);
    const Index budget = inside ? -1 : (mesh->is_inlet(i, k) ? at->mass_in() : at->mass_top());
    out = {at->continuity(i, k - 1), at->continuity(i, k), at->phi(i, k - 1), at->phi(i, k), budget};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const double area = grid().dx(i);
    const Row<S> phi{in.y[phi_], in.y[phi_ + 1], in.y[phi_ + 2], in.y[phi_ + 3]};
    const S volume = area * in.y[w_], grains = area * grain_flux_z(c, i, k, in.y[w_], phi, in.y[heap_]);
    out[0] += volume;
    out[1] -= volume;
    out[2] += grains;
    out[3] -= grains;
    const double counted = mesh->is_inlet(i, k) || mesh->has_cell(i, k) ? -1.0 : 1.0;  // inwards or outwards
    out[4] -= (counted * c.grains_across()) * grains;
  }
};

/// d(phi)/dt of (5.13).
struct Storage : Kernel {
  static constexpr int n_in = 1, n_out = 1;
  static constexpr bool uses_rate = true;

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    in = {at->phi(i, k)};
    out = in;
  }
  template <class S>
  void evaluate(const Context&, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    out[0] += grid().dx(i) * grid().dz(k) * in.rate[0];
  }
};

/// Rates of the unknowns that only sum up.
struct Rates : Kernel {
  static constexpr int n_in = 1, n_out = 1;
  static constexpr bool uses_rate = true;
  std::vector<Index> rows;
  [[nodiscard]] Index alike(Index) const { return 1; }

  [[nodiscard]] Index n_places() const { return static_cast<Index>(rows.size()); }
  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {rows[number]};
    out = in;
  }
  template <class S>
  void evaluate(const Context&, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += in.rate[0];
  }
};

/// The heap's height H in the jet's corridor, for the highest point in (5.12): the mean of the fourth power of the heights of dense
/// grains over the corridor's width, H^4 = (1/width) sum of 4 Z^3 over their cells; H follows it within the time of a free fall from
/// the inlet.
struct HeapUnderJet : Kernel {
  static constexpr int n_in = 2, n_out = 1;
  [[nodiscard]] Index alike(Index) const { return 1; }

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    const bool counts = share(i, k) > 0.0;
    in = {counts ? at->phi(i, k) : -1, counts ? at->heap() : -1};
    out = {in[1]};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const JetRegion& jet = mesh->jet();
    const double Z = jet.height(grid().x_centre(i), grid().z_centre(k));
    const double power = share(i, k) * grid().dx(i) * grid().dz(k) / jet.width() * 4.0 * Z * Z * Z;
    const S H = in.y[1] + jet.clearance();
    out[0] -= (power / c.fall_time()) * densely_filled(in.y[0]) / (4.0 * H * H * H);
  }

 private:
  [[nodiscard]] double share(int i, int k) const {
    const double x = grid().x_centre(i), z = grid().z_centre(k);
    return mesh->jet().height(x, z) > 0.0 ? mesh->jet().share_of_cell(x, z, grid().dx(i), grid().dz(k)) : 0.0;
  }
};

/// The other side of that balance.
struct HeapRelaxation : Kernel {
  static constexpr int n_in = 1, n_out = 1;
  [[nodiscard]] Index alike(Index) const { return 1; }

  [[nodiscard]] Index n_places() const { return 1; }
  void connect(Index, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {at->heap()};
    out = in;
  }
  template <class S>
  void evaluate(const Context& c, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const S reach = in.y[0] + mesh->jet().clearance(), HH = in.y[0] * in.y[0];
    out[0] += HH * HH / (4.0 * reach * reach * reach * c.fall_time());
  }
};

}  // namespace talus::two_fluid
