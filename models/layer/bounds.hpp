#pragma once

#include <algorithm>

#include "layer/context.hpp"

namespace talus::layer {

/// What the top layer has above it.
enum class Top : std::uint8_t {
  grains,     ///< a free surface of grains: the shear rate grows as the root of the depth
  fluid,      ///< a free surface of a viscous fluid: as its slope and stretching let it be
  no_slip,    ///< a lid at which grains stick
  free_slip,  ///< a lid without shear stress
};

inline Top top_of(const Parameters& par) {
  if (par.box.lid) return par.box.lid->contact == Contact::no_slip ? Top::no_slip : Top::free_slip;
  return par.fluid ? Top::fluid : Top::grains;
}

/// Speed along x [m/s] of the base and of the lid at face f, where grains stick to them.
inline double base_speed(const Context& c, int f) {
  const Parameters& par = *c.parameters;
  return par.forcing ? par.forcing->base_speed(f, c.t) : par.box.base_speed;
}
inline double lid_speed(const Context& c, int f) {
  const Parameters& par = *c.parameters;
  return par.forcing ? par.forcing->lid_speed(f, c.t) : par.box.lid->speed;
}

/// How a boundary to which grains stick moves at a face.
struct Sticking {
  double speed;              ///< along x [m/s]
  double stretch;            ///< how that grows along x [1/s]
  double slip_length = 0.0;  ///< Navier's l, of a base on which grains slip [m]
};
inline Sticking sticking(double (*speed)(const Context&, int), const Context& c, int f) {
  const double here = speed(c, f);
  if (!c.parameters->forcing) return {here, 0.0};
  const bool joined = c.columns.periodic;
  const int left = joined ? f - 1 : std::max(f - 1, 0), right = joined ? f + 1 : std::min(f + 1, c.columns.n_columns);
  return {here, (speed(c, right) - speed(c, left)) / ((right - left) * c.columns.dx())};
}

inline Sticking base_contact(const Context& c, int f) {
  Sticking base = sticking(base_speed, c, f);
  base.slip_length = c.parameters->box.base_slip_length;
  return base;
}

/// What bounds a column from below and above: the speeds [m/s] are those in its middle, where grains stick.
struct Bounds {
  Contact base;
  double base_speed;
  double base_slip_length;  ///< Navier's [m]
  bool base_slides;         ///< grains stick to the base only as far as its friction holds them
  Top top;
  double lid_speed;
};

inline Bounds bounds(const Context& c, int i) {
  const auto middle = [&](double (*speed)(const Context&, int)) { return 0.5 * (speed(c, i) + speed(c, i + 1)); };
  const auto& box = c.parameters->box;
  Bounds b{box.base, 0.0, box.base_slip_length, box.base_friction.has_value(), top_of(*c.parameters), 0.0};
  if (b.base == Contact::no_slip) b.base_speed = middle(base_speed);
  if (b.top == Top::no_slip) b.lid_speed = middle(lid_speed);
  return b;
}

}  // namespace talus::layer
