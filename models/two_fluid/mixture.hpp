#pragma once

#include "fv/sharp_transport.hpp"
#include "rheology/viscosity.hpp"
#include "two_fluid/context.hpp"

namespace talus::two_fluid {

/// Onset of the share of grains in a mixture's viscosity [1]: what is less than nothing has none.
inline constexpr double share_onset = 1e-6;

/// eta of (3.17), with the model's floor under the rate [Pa s].
template <class S>
S grain_viscosity(const Context& c, const S& D_norm_squared, const S& p) {
  const Parameters& par = *c.parameters;
  return rheology::viscosity(par.law, par.grains, par.regularisation, D_norm_squared, c.rate_floor, p);
}

/// Mixture viscosity [Pa s]: (5.7), or the harmonic mean, of a fluid of `eta` that fills the share phi.
template <class S>
S mixture_viscosity(const Context& c, const S& phi, const S& eta) {
  const auto& n = c.parameters->numerics;
  const S share = fv::above_zero(phi, share_onset);
  if (n.averaging == Averaging::arithmetic) return share * eta + (1.0 - share) * n.air.eta;
  const S both = share * n.air.eta + (1.0 - share) * eta;
  return core::select_above(
      both, 0.0, [&] { return S(eta * n.air.eta / both); }, [] { return S(0.0); });
}

/// Strain rates in the middle of a cell or at a corner [1/s].
template <class S>
struct Strain {
  S D_xx, D_xz;
  [[nodiscard]] S norm_squared() const { return D_xx * D_xx + D_xz * D_xz; }
};

}  // namespace talus::two_fluid
