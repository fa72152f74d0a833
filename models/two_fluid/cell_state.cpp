#include "two_fluid/cell_state.hpp"

#include <cmath>
#include <limits>

#include "rheology/well_posedness.hpp"
#include "two_fluid/terms/stress.hpp"

namespace talus::two_fluid {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr CellState no_cell{nothing, nothing, nothing, nothing, nothing, nothing, nothing, nothing,
                            nothing, false,   nothing, nothing, nothing, nothing, {}};

}  // namespace

CellState cell_state(const TwoFluid& system, const Context& c, std::span<const double> y, int i, int k) {
  if (!system.mesh().has_cell(i, k)) return no_cell;
  const auto& par = system.parameters();
  std::array<Index, CentreSlots::n_in> in{};
  std::array<double, CentreSlots::n_in> v{};
  CentreSlots::connect(system.unknowns(), i, k, in);
  for (int j = 0; j < CentreSlots::n_in; ++j) v[j] = fv::read(y, in[j]);
  const double D_squared = CentreSlots::strain(system.mesh(), i, k, v).norm_squared();

  CellState s{};
  s.u = 0.5 * (v[CentreSlots::u_ + 2] + v[CentreSlots::u_ + 3]);
  s.w = 0.5 * (v[CentreSlots::w_ + 2] + v[CentreSlots::w_ + 3]);
  s.phi = v[CentreSlots::phi_];
  s.p = v[CentreSlots::p_];
  s.D_norm = std::sqrt(D_squared);
  s.eta = grain_viscosity(c, D_squared, s.p);
  s.eta_mixture = mixture_viscosity(c, s.phi, s.eta);
  s.I = s.mu = s.C = s.nu = s.q = s.growth_per_k2 = nothing;
  if (!(s.phi > dense)) return s;
  s.I = rheology::inertial_number(par.grains, par.regularisation, D_squared, c.rate_floor, s.p);
  const auto response = rheology::response(par.law, s.I);
  s.mu = response.mu;
  s.C = rheology::condition_C(response);
  s.nu = response.nu;
  s.q = response.q;
  s.capped = rheology::is_capped(par.law, par.grains, par.regularisation, D_squared, c.rate_floor, s.p);
  s.growth_per_k2 = diagnostics::growth_per_square(response, s.capped, s.eta, par.grains.rho());
  s.flow_class = diagnostics::flow_class(response, s.capped);
  return s;
}

double heap_height(const TwoFluid& system, std::span<const double> y, int i) {
  const auto& g = system.mesh().grid();
  double height = 0.0;
  for (int k = 0; k < g.n_layers(); ++k) {
    const double phi = fv::read(y, system.unknowns().phi(i, k));
    height += phi * g.dz(k);
    if (!(phi > dense)) break;
  }
  return height;
}

}  // namespace talus::two_fluid
