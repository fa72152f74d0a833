#pragma once

namespace talus::layer {

/// A vector along x and z.
struct Vector {
  double x, z;
};

/// What drives a flow beside weight, as given functions of place on the grid and of time [s]: the sources and the data at the
/// boundaries of a manufactured solution. None of it depends on the unknowns. Faces are counted as grid::Columns does; in a
/// periodic box those beyond an end may be asked for.
class Forcing {
 public:
  Forcing() = default;
  Forcing(const Forcing&) = delete;
  Forcing& operator=(const Forcing&) = delete;
  virtual ~Forcing() = default;

  /// Force [N/m3] in the middle of the momentum volume about (face f, layer k).
  [[nodiscard]] virtual Vector force(int f, int k, double t) const = 0;
  /// Speed of base and lid along x [m/s] at face f, where grains do not slip.
  [[nodiscard]] virtual double base_speed(int /*f*/, double /*t*/) const { return 0.0; }
  [[nodiscard]] virtual double lid_speed(int /*f*/, double /*t*/) const { return 0.0; }
  /// As experiment::Lid::pressure [Pa].
  [[nodiscard]] virtual double lid_pressure(double /*t*/) const { return 0.0; }
  /// Pressure [Pa] on the free surface of column i: the normal stress there with the opposite sign.
  [[nodiscard]] virtual double surface_pressure(int /*i*/, double /*t*/) const { return 0.0; }
  /// What pulls along the free surface at face f, per unit length of x [Pa].
  [[nodiscard]] virtual Vector surface_pull(int /*f*/, double /*t*/) const { return {0.0, 0.0}; }
};

}  // namespace talus::layer
