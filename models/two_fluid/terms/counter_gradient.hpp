#pragma once

#include "two_fluid/grain_flux.hpp"
#include "two_fluid/terms/kernel.hpp"

namespace talus::two_fluid {

/// Differences of phi between cells below this one have no direction [1].
inline constexpr double least_gradient = 1e-3;

/// Flux of grains through a face [m/s] of the counter-gradient method, (5.8) written for the grains: c |u| phi (1 - phi) n up the gradient
/// of phi, n its unit vector's part across the face. Differences of phi `across` the face and `along` it, in one unit; phi of the side
/// that has less goes to the side that has more, as far as there is room.
template <class S>
S counter_gradient_flux(double strength, const S& speed_squared, double upwind_speed, const S& across, const S& along,
                        const S& behind, const S& ahead) {
  using std::sqrt;
  using core::sqrt;
  const S size = sqrt(across * across + along * along + least_gradient * least_gradient);
  const S speed = strength * sqrt(speed_squared + upwind_speed * upwind_speed);
  return core::select_above(
      across, 0.0, [&] { return S(speed * (across / size) * fv::parting(behind, ahead)); },
      [&] { return S(speed * (across / size) * fv::parting(ahead, behind)); });
}

/// The sharpening of (5.8) between the columns beside a face, at the speed of the mixture there.
struct CounterGradientAlong : Kernel {
  static constexpr int n_in = 11, n_out = 2;
  enum In { u_, w_, phi_ = 5 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [f, k] = place(number);
    in = {at->u(f, k),           at->w(f - 1, k),   at->w(f - 1, k + 1), at->w(f, k),
          at->w(f, k + 1),       at->phi(f - 1, k), at->phi(f, k),       at->phi(f - 1, k - 1),
          at->phi(f - 1, k + 1), at->phi(f, k - 1), at->phi(f, k + 1)};
    const bool inside = mesh->has_cell(f - 1, k) && mesh->has_cell(f, k);
    out = {inside ? at->phi(f - 1, k) : -1, inside ? at->phi(f, k) : -1};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [f, k] = place(number);
    const auto& y = in.y;
    const S w = 0.25 * (y[w_] + y[w_ + 1] + y[w_ + 2] + y[w_ + 3]);
    const double aspect = grid().across_face(f) / (2.0 * grid().dz(k));
    // On the base phi has no gradient across it: the cell stands in for the one below.
    const S below_left = k > 0 ? y[phi_ + 2] : y[phi_], below_right = k > 0 ? y[phi_ + 4] : y[phi_ + 1];
    const S along = (0.5 * aspect) * (y[phi_ + 3] + y[phi_ + 5] - below_left - below_right);
    const auto& n = c.parameters->numerics;
    const S flux = grid().dz(k) * counter_gradient_flux(n.counter_gradient, S(y[u_] * y[u_] + w * w), n.upwind_speed,
                                                        S(y[phi_ + 1] - y[phi_]), along, y[phi_], y[phi_ + 1]);
    out[0] += flux;
    out[1] -= flux;
  }
};

/// The same between layers.
struct CounterGradientUp : Kernel {
  static constexpr int n_in = 11, n_out = 2;
  enum In { w_, u_, phi_ = 5 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto [i, k] = place(number);
    in = {at->w(i, k),           at->u(i, k - 1),   at->u(i + 1, k - 1), at->u(i, k),
          at->u(i + 1, k),       at->phi(i, k - 1), at->phi(i, k),       at->phi(i - 1, k - 1),
          at->phi(i + 1, k - 1), at->phi(i - 1, k), at->phi(i + 1, k)};
    const bool inside = mesh->has_cell(i, k - 1) && mesh->has_cell(i, k);
    out = {inside ? at->phi(i, k - 1) : -1, inside ? at->phi(i, k) : -1};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const auto [i, k] = place(number);
    const auto& y = in.y;
    const S u = 0.25 * (y[u_] + y[u_ + 1] + y[u_ + 2] + y[u_ + 3]);
    const double aspect = grid().across_interface(k) / (2.0 * grid().dx(i));
    const S along = (0.5 * aspect) * (y[phi_ + 3] + y[phi_ + 5] - y[phi_ + 2] - y[phi_ + 4]);
    const auto& n = c.parameters->numerics;
    const S flux = grid().dx(i) * counter_gradient_flux(n.counter_gradient, S(y[w_] * y[w_] + u * u), n.upwind_speed,
                                                        S(y[phi_ + 1] - y[phi_]), along, y[phi_], y[phi_ + 1]);
    out[0] += flux;
    out[1] -= flux;
  }
};

}  // namespace talus::two_fluid
