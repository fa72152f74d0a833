#pragma once

#include <span>
#include <vector>

#include "steady/answer.hpp"
#include "steady/profile_problem.hpp"

namespace talus::steady {

/// Steady uniform flow of a regularised layer: d(eta du/dz)/dz + rho g sin zeta = (2 mu_w/W) p_+ tanh(u/u_c), u = 0 at
/// z = -H, no stress at z = 0, p = -rho g z cos zeta. Tends to `UniformFlow` as u_c -> 0. Second order in the number of
/// cells.
class RegularisedProfile {
 public:
  static constexpr int default_cells = 2000;

  /// None where no steady state exists, with the reason. Throws std::invalid_argument on bad input.
  static Answer<RegularisedProfile> at(const RegularisedLayer& layer, double zeta, int cells = default_cells);

  /// Node heights [m] from the surface, 0, to the base, -H; shape cells + 1.
  [[nodiscard]] std::span<const double> z() const { return z_; }
  /// u [m/s] at the nodes.
  [[nodiscard]] std::span<const double> speeds() const { return u_; }
  /// u [m/s] at any z in [-H, 0], by cubic interpolation in the grid's coordinate.
  [[nodiscard]] double speed(double z) const;
  [[nodiscard]] double surface_speed() const { return u_.front(); }
  /// Q [kg/s].
  [[nodiscard]] double flux() const { return flux_; }
  /// Newton iterations.
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  explicit RegularisedProfile(const ProfileProblem& problem);
  ProfileProblem problem_;
  std::vector<double> z_, u_;
  double flux_ = 0.0;
  int iterations_ = 0;
};

/// zeta [rad] at which a regularised layer carries Q [kg/s] > 0: the exact slope for a model with these
/// regularisations.
[[nodiscard]] Answer<double> slope_of_flux(const RegularisedLayer& layer, double Q,
                                           int cells = RegularisedProfile::default_cells);

}  // namespace talus::steady
