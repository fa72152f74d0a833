#pragma once

#include "core/scalar.hpp"
#include "layer/parameters.hpp"

namespace talus::layer {

/// The share of a column that may flow: 0 in the immobile film H <= Hs, then 1 - exp(-((H - Hs)/Hs)^2). C1.
template <class S>
S mobility(const Numerics& n, const S& H) {
  using std::exp;
  using core::exp;
  return core::select_above(
      H, n.film,
      [&] {
        const S s = (H - n.film) / n.film;
        return S(1.0 - exp(-(s * s)));
      },
      [] { return S(0.0); });
}

/// How much a column counts as a film: 1 for H <= Hs, 0 for H >= Hs (1 + film_blend), C1 between.
template <class S>
S filminess(const Numerics& n, const S& H) {
  return core::select_above(
      H, n.film,
      [&] {
        const S s = (H - n.film) / (n.film * n.film_blend);
        return core::select_above(
            s, 1.0, [] { return S(0.0); }, [&] { return S(1.0 - s * s * (3.0 - 2.0 * s)); });
      },
      [] { return S(1.0); });
}

/// How much the thickness jumps between two columns: 0 where it changes by less than `jump_from` of itself, 1 beyond
/// `jump_to`, C1 between.
template <class S>
S jump(const Numerics& n, const S& H_left, const S& H_right) {
  const S change = 2.0 * (H_right - H_left) / (H_right + H_left);
  const double from = n.jump_from * n.jump_from, to = n.jump_to * n.jump_to;
  const S s = (change * change - from) / (to - from);
  return core::select_above(
      s, 0.0,
      [&] {
        return core::select_above(
            s, 1.0, [] { return S(1.0); }, [&] { return S(s * s * (3.0 - 2.0 * s)); });
      },
      [] { return S(0.0); });
}

/// How much the flux between two columns is that of the heap: 1 where neither is a film and the thickness does not jump.
template <class S>
S heap_share(const Numerics& n, const S& H_left, const S& H_right) {
  return (1.0 - filminess(n, H_left)) * (1.0 - filminess(n, H_right)) * (1.0 - jump(n, H_left, H_right));
}

/// Volume flux of one layer through a face between two columns, per unit gap [m2/s]: u times the mean thickness in the heap;
/// where either column is a film, or the thickness jumps, the mobile part of the column that gives, so that no column gives
/// more than it holds above Hs. u_+- = (u +- sqrt(u^2 + e^2))/2. `rest` is 1 - heap_share.
template <class S>
S face_flux(const Numerics& n, const S& u, const S& h_left, const S& h_right, const S& mobile_left,
            const S& mobile_right, const S& rest) {
  using std::sqrt;
  using core::sqrt;
  return core::select_above(
      rest, 0.0,
      [&] {
        const S root = sqrt(u * u + n.film_speed * n.film_speed);
        const S donor = 0.5 * ((u + root) * h_left * mobile_left + (u - root) * h_right * mobile_right);
        return S((1.0 - rest) * u * 0.5 * (h_left + h_right) + rest * donor);
      },
      [&] { return S(0.5 * u * (h_left + h_right)); });
}

/// Flux out over an open end; grains never come in there. `sign` is +1 at the right end, -1 at the left.
template <class S>
S end_flux(const Numerics& n, double sign, const S& u, const S& h, const S& mobile) {
  using std::sqrt;
  using core::sqrt;
  return 0.5 * (u + sign * sqrt(u * u + n.film_speed * n.film_speed)) * h * mobile;
}

/// Flux through face `c` of a kernel's columns, whichever kind of face it is; u is zero at a wall.
template <class S, class HeightsOf>
S flux_through(const Numerics& n, const HeightsOf& g, bool left_end, bool right_end, int c, int k, const S& u) {
  if (left_end) return end_flux(n, -1.0, u, g.h(c, k), g.mobility(c));
  if (right_end) return end_flux(n, 1.0, u, g.h(c - 1, k), g.mobility(c - 1));
  return face_flux(n, u, g.h(c - 1, k), g.h(c, k), g.mobility(c - 1), g.mobility(c), g.film_share(c));
}

}  // namespace talus::layer
