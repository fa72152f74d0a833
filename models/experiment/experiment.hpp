#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "experiment/piecewise_linear.hpp"

namespace talus::experiment {

/// How grains meet a wall along which they may move.
enum class Contact : std::uint8_t {
  no_slip,   ///< at the wall's own velocity
  free_slip  ///< without shear stress
};

/// A rigid lid on the grains, in place of a free surface: the box stays as full as it is.
struct Lid {
  Contact contact = Contact::no_slip;
  double speed = 0.0;     ///< along x [m/s]; not read under free slip
  double pressure = 0.0;  ///< of the grains on the lid, at its right end [Pa]
};

/// The box between the side walls, seen along the base: x down the base from the left end, z normal to it.
struct Box {
  double length;            ///< along the base [m]
  double height;            ///< normal to the base; the inlet lies there [m]
  double tilt;              ///< of the base against the horizontal, theta [rad]; positive: down to the right
  double gap;               ///< between the side walls, W [m]
  double gravity;           ///< g [m/s2]
  bool periodic = false;    ///< the right end continues at the left end
  bool left_open = true;    ///< not periodic: grains may leave over the left end; else a wall
  double base_slope = 0.0;  ///< db/dx of the base against the grid's x axis [1]; the column lines stay normal to x
  bool right_open = true;   ///< as left_open
  Contact end_walls = Contact::free_slip;  ///< of those ends that are walls
  Contact base = Contact::no_slip;
  double base_speed = 0.0;  ///< along x [m/s]; not read under free slip
  std::optional<double> base_friction =
      {};                         ///< mu_b: grains slide on a no-slip base where they would pull harder than mu_b p [1]
  double base_slip_length = 0.0;  ///< Navier's l of a no-slip base [m]: grains slip on it at l du/dz; 0: they stick
  std::optional<Lid> lid = {};    ///< none: the surface is free
};

/// Whether grains may move along a no-slip base.
inline bool base_slides(const Box& box) { return box.base_friction || box.base_slip_length > 0.0; }

/// Slope of the base against the horizontal, positive down to the right [rad].
inline double base_angle(const Box& box) { return box.tilt - std::atan(box.base_slope); }

/// Thickness normal to the base of a uniform layer that measures H [m] normal to x.
inline double normal_thickness(const Box& box, double H) { return H * std::cos(std::atan(box.base_slope)); }

/// How the box is moved while grains flow, over time [s]. Empty: it stands still.
struct Motion {
  PiecewiseLinear tilt;  ///< of the base, as Box::tilt [rad]
  PiecewiseLinear gap;   ///< W [m]
};

/// The box at time t [s].
inline Box box_at(Box box, const Motion& motion, double t) {
  box.tilt = value_at(motion.tilt, t, box.tilt);
  box.gap = value_at(motion.gap, t, box.gap);
  return box;
}

/// Grains poured from the inlet: a column source of mass, smooth in time. The inlet is open from `start` to `stop`; from each of
/// `times` on it passes that one of `shares` of the rate, before them all of it. A ramp follows each change.
struct Inflow {
  double rate = 0.0;      ///< Q [kg/s]
  double position = 0.0;  ///< centre of the inlet along x at z = box height [m]
  double width = 0.0;     ///< standard deviation sigma of the jet's footprint along x [m]
  double start = 0.0;     ///< [s]
  double stop = std::numeric_limits<double>::infinity();  ///< [s]
  double ramp = 0.2;                                      ///< duration of the C2 ramp that follows each change [s]
  std::vector<double> times = {};                         ///< at which the share changes, ascending [s]
  std::vector<double> shares = {};                        ///< of `rate`, as many as times [1]
  bool along_gravity = true;                              ///< the jet falls along gravity from the inlet; else along -z
  bool momentum = false;  ///< the jet brings the momentum of its free fall; else the speed of the grains it meets
};

struct Wall {
  double mu_w;  ///< side-wall friction [1]
  double u_c;   ///< speed at which wall friction turns on, tanh(|u| / u_c) [m/s]
};

}  // namespace talus::experiment
