#pragma once

#include <cmath>

#include "core/scalar.hpp"
#include "triangle/parameters.hpp"

namespace talus::triangle {

/// The heap as a triangle: its apex on the line along which the jet falls, its right toe at the right end of the box, its left
/// face at a given slope. x [m] runs down the base from the left end, z [m] normal to it.
template <class S>
struct Shape {
  S apex_x, apex_z;
  S left_toe;  ///< x where the left face meets the base, or the base continued beyond the left end
  S rise;      ///< of the right face over the base, apex_z over its length along x [1]
  S cut_off;   ///< part of the triangle's area that lies beyond the left end [m2]
};

/// What of the shape no mass changes.
struct Frame {
  double drift;     ///< dx/d(-z) of the falling jet [1]
  double landing;   ///< x at which the jet would meet the bare base [m]
  double left_cot;  ///< cotangent of the left face's slope over the base [1]

  explicit Frame(const Parameters& par)
      : drift(par.inflow.along_gravity ? std::tan(par.box.tilt) : 0.0),
        landing(par.inflow.position + drift * par.box.height),
        left_cot(1.0 / std::tan(par.left_slope + par.box.tilt)) {}
};

/// The triangle of `area` [m2] >= 0, what lies beyond the left end included.
template <class S>
Shape<S> shape_of_area(const Frame& frame, double length, const S& area) {
  using std::sqrt;
  using core::sqrt;
  // area = apex_z (length - left_toe)/2 with both linear in apex_z: the positive root, in the form that is exact for a small area.
  const double reach = length - frame.landing, widening = frame.drift + frame.left_cot;
  const S apex_z = 4.0 * area / (reach + sqrt(reach * reach + 8.0 * widening * area));
  const S apex_x = frame.landing - frame.drift * apex_z;
  const S left_toe = apex_x - frame.left_cot * apex_z;
  const S beyond = core::select_above(
      S(-left_toe), 0.0, [&] { return S(-left_toe); }, [] { return S(0.0); });
  return {apex_x, apex_z, left_toe, S(apex_z / (length - apex_x)), S(beyond * beyond * (0.5 / frame.left_cot))};
}

/// Height of the surface over the base at x [m].
inline double height_at(const Shape<double>& shape, double length, double x) {
  if (x <= shape.left_toe || x >= length) return 0.0;
  if (x < shape.apex_x) return shape.apex_z * (x - shape.left_toe) / (shape.apex_x - shape.left_toe);
  return shape.apex_z * (length - x) / (length - shape.apex_x);
}

}  // namespace talus::triangle
