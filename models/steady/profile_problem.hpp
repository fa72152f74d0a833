#pragma once

#include <span>
#include <vector>

#include "rheology/viscosity.hpp"
#include "steady/channel.hpp"

namespace talus::steady {

/// A uniform layer over a no-slip base with the regularisations of the dynamic models.
struct RegularisedLayer {
  Channel channel;
  rheology::Regularisation regularisation;
  double u_c;        ///< wall friction turns on as tanh(u/u_c) [m/s]
  double thickness;  ///< H [m]
};

/// The discrete force balance of a layer of slope zeta [rad] in n cells: tau_i - tau_(i-1) = V_i (rho g sin zeta - (2
/// mu_w/W) p_+ tanh(u_i/u_c)) at nodes 0 (surface) to n - 1; u_n = 0 on the base. Nodes lie at depth h0 sinh^2(a i/n):
/// u is smooth in i/n at the surface, where u ~ (-z)^1.5, and cells grow below the flow. The balance is the gradient of
/// a strictly convex function of u, for tau grows with the shear rate and friction with u.
class ProfileProblem {
 public:
  ProfileProblem(const RegularisedLayer& layer, double zeta, int cells);

  [[nodiscard]] int size() const { return static_cast<int>(volume_.size()); }
  /// Depths [m] of the nodes, from 0 to H; shape size() + 1.
  [[nodiscard]] std::span<const double> depths() const { return depth_; }
  /// Index, as a real number, at which a depth [m] lies between the nodes.
  [[nodiscard]] double position(double depth) const;
  /// Whether some profile balances: full wall friction leaves no more stress than the law can carry at any rate.
  [[nodiscard]] bool solvable() const;
  /// Newton's method from rest for the jumps u_i - u_(i+1) [m/s] of the speed across the faces, shape size(). Returns
  /// the number of iterations, or -1 where 200 did not bring the steps below 1e-10 of the largest speed and the forces
  /// below 1e-7 of the weight. Jumps and not speeds are the unknowns: in a plug they are far below the rounding of the
  /// speed.
  int solve(std::vector<double>& jump) const;
  /// Speeds [m/s] at the nodes above the base, shape size().
  [[nodiscard]] std::vector<double> speeds(std::span<const double> jump) const;
  /// Q [kg/s].
  [[nodiscard]] double flux(std::span<const double> u) const;

 private:
  /// Positive second derivatives of the convex function: of each face by its jump, of each node by its speed [Pa s/m].
  struct Stiffness {
    std::vector<double> face, node;
  };
  /// Force on each node a unit area [Pa], the gradient with its sign reversed.
  void force(std::span<const double> jump, std::vector<double>& on_node, Stiffness* stiffness) const;
  /// One Newton step; true, and nothing done, where `solve` may stop.
  bool step(std::vector<double>& jump) const;

  RegularisedLayer layer_;
  double h0_, a_, weight_, floor_;
  std::vector<double> depth_, spacing_, volume_;  ///< node depths, their differences, cell volumes a unit area [m]
  std::vector<double> face_pressure_;             ///< [Pa]
  std::vector<double> full_friction_;             ///< (2 mu_w/W) p_+ at the nodes [Pa/m]
};

}  // namespace talus::steady
