#pragma once

#include "fv/sharp_transport.hpp"
#include "two_fluid/context.hpp"

namespace talus::two_fluid {

/// phi in four cells in a row, the face between the middle two.
template <class S>
struct Row {
  const S &far_behind, &behind, &ahead, &far_ahead;
};

/// Of the cells in a row about a face.
struct Spacings {
  double behind, ahead;                   ///< widths of the two cells beside the face [m]
  double far_behind, between, far_ahead;  ///< distances between middles, in their order [m]
};

/// phi that goes through a face from `giver` to `taker`: of second order by the share `second` [1], else the giver's.
template <class S>
S carried(const S& second, const S& before, const S& giver, const S& taker, double to_before, double to_taker) {
  return giver + second * (fv::limited(before, giver, taker, to_before, to_taker) - giver);
}

/// Flux of grains a unit area through a face [m/s]: (5.13) and the return of what is out of bounds, with the speed of the mixture and
/// `parting_speed` f_ga e.n, both positive from behind to ahead; of the latter the share `free` [1] is at work.
template <class S>
S grain_flux(const Numerics& n, const Spacings& d, const S& speed, double parting_speed, const S& free, const S& omega,
             const Row<S>& phi) {
  S from_behind = phi.behind, from_ahead = phi.ahead;
  if (n.transport != Transport::upwind) {
    const S second = n.transport == Transport::limited ? S(1.0) : S(1.0 - omega);
    from_behind = carried(second, phi.far_behind, phi.behind, phi.ahead, d.behind / d.far_behind, d.behind / d.between);
    from_ahead = carried(second, phi.far_ahead, phi.ahead, phi.behind, d.ahead / d.far_ahead, d.ahead / d.between);
  }
  S flux = fv::upwind_flux(speed, n.upwind_speed, from_behind, from_ahead);
  if (n.jet_segregation) {
    if (parting_speed > 0.0) flux += parting_speed * free * fv::parting(from_behind, phi.ahead);
    if (parting_speed < 0.0) flux += parting_speed * free * fv::parting(from_ahead, phi.behind);
  } else {
    if (parting_speed > 0.0) flux += parting_speed * free * omega * fv::parting(phi.behind, phi.ahead);
    if (parting_speed < 0.0) flux += parting_speed * free * omega * fv::parting(phi.ahead, phi.behind);
  }
  if (n.return_speed > 0.0) flux += n.return_speed * (fv::beyond_bounds(phi.behind) - fv::beyond_bounds(phi.ahead));
  return flux;
}

/// Flux of grains through face (f, k), along x [m/s]. phi of columns f - 2 to f + 1, and `beneath` the giver (`Mesh::beneath_giver`).
template <class S>
S grain_flux_x(const Context& c, int f, int k, const S& u, const Row<S>& phi, const S& beneath, const S& heap) {
  const auto& g = c.mesh->grid();
  const Spacings d{g.dx(f - 1), g.dx(f), g.across_face(f - 1), g.across_face(f), g.across_face(f + 1)};
  const bool inside = c.mesh->has_cell(f - 1, k) && c.mesh->has_cell(f, k);
  const double parting = inside ? c.segregation_x : 0.0;
  const S omega = c.mesh->jet().omega(g.x_nodes[f], g.z_centre(k), heap);
  const bool settles = c.parameters->numerics.direction == Direction::settling;
  const S free = !settles ? S(1.0) : k == 0 ? S(0.0) : fv::not_less(S(1.0 - beneath));
  return grain_flux(c.parameters->numerics, d, u, parting, free, omega, phi);
}

/// Flux of grains through interface (i, k > 0), along z [m/s]. phi of layers k - 2 to k + 1; what is poured has a share of its own.
template <class S>
S grain_flux_z(const Context& c, int i, int k, const S& w, const Row<S>& phi, const S& heap) {
  if (c.mesh->is_inlet(i, k)) return c.parameters->numerics.inlet_fraction * w;
  const auto& g = c.mesh->grid();
  const Spacings d{g.dz(k - 1), g.dz(k), g.across_interface(k - 1), g.across_interface(k), g.across_interface(k + 1)};
  const bool inside = c.mesh->has_cell(i, k - 1) && c.mesh->has_cell(i, k);
  const double parting = inside ? c.segregation_z : 0.0;
  const S omega = c.mesh->jet().omega(g.x_centre(g.column(i)), g.z_nodes[k], heap);
  return grain_flux(c.parameters->numerics, d, w, parting, S(1.0), omega, phi);
}

/// Flux of mass that belongs to a flux of volume and one of grains [kg/m2/s].
template <class S>
S mass_flux(const Context& c, const S& speed, const S& grains) {
  return c.rho_air() * speed + c.excess() * grains;
}

}  // namespace talus::two_fluid
