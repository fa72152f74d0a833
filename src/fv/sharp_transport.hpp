#pragma once

#include <cmath>

#include "core/scalar.hpp"

/// Fluxes of a share phi of volume, between 0 and 1: monotone in what is given and taken, and with a continuous derivative.
namespace talus::fv {

/// Differences of phi below this one are not steepened [1].
inline constexpr double unsteepened = 1e-4;
/// Width of the onset of `above_zero` [1].
inline constexpr double onset = 1e-4;

/// max(x, 0), but for a smooth onset: x^2/(x + onset). Keeps a flux from what is not there, or into what is full.
template <class S>
S above_zero(const S& x, double width = onset) {
  return core::select_above(
      x, 0.0, [&] { return S(x * x / (x + width)); }, [] { return S(0.0); });
}

/// phi on the face through which `giver` gives to `taker`, `before` lying behind the giver: second order where phi is smooth, the
/// giver's where it has an extremum. A limiter with a continuous derivative, total variation diminishing.
/// `to_before`, `to_taker`: width of the giving cell over its distance to either.
template <class S>
S limited(const S& before, const S& giver, const S& taker, double to_before, double to_taker) {
  const S a = (giver - before) * to_before, b = (taker - giver) * to_taker, ab = a * b;
  return core::select_above(
      ab, 0.0,
      [&] {
        const double least = unsteepened * unsteepened;
        const S aa = a * a, bb = b * b;
        return S(giver + 0.5 * ab * ab * (a + b) / (aa * aa + bb * bb + least * least));
      },
      [&] { return giver; });
}

/// speed phi with phi of the giving side; `scale` smooths the change of sides, which costs a diffusion of scale/2 a cell.
template <class S>
S upwind_flux(const S& speed, double scale, const S& behind, const S& ahead) {
  using std::sqrt;
  using core::sqrt;
  const S size = sqrt(speed * speed + scale * scale);
  return 0.5 * ((speed + size) * behind + (speed - size) * ahead);
}

/// Value that a flux carries: the giver's where |flux| is well above `scale`, the mean where it is zero.
template <class S, class Scale>
S upwind_value(const S& flux, const Scale& scale, const S& behind, const S& ahead) {
  using std::sqrt;
  using core::sqrt;
  const S sign = flux / sqrt(flux * flux + scale * scale);
  return 0.5 * (behind + ahead) - 0.5 * sign * (ahead - behind);
}

/// x where it is not below 0, else a little below, never less than minus `width`: linear through 0.
template <class S>
S not_less(const S& x, double width = 1e-3) {
  return core::select_above(
      x, 0.0, [&] { return x; }, [&] { return S(x / (1.0 - x / width)); });
}

/// phi (1 - phi) for a flux that parts the phases: phi of where it comes from, 1 - phi of where it goes to. Sharp, and zero out of
/// an empty cell and into a full one.
template <class S>
S parting(const S& from, const S& to) {
  return not_less(from) * not_less(S(1.0 - to));
}

/// By how much phi is above 1, or minus by how much it is below 0, with smooth onsets: a flux in proportion to its difference returns
/// what errors of time stepping and iteration have put out of bounds, and is none within them.
template <class S>
S beyond_bounds(const S& phi) {
  constexpr double width = 1e-6;
  return above_zero(S(phi - 1.0), width) - above_zero(S(-phi), width);
}

}  // namespace talus::fv
