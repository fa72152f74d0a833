#pragma once

#include <array>
#include <string_view>

#include "rheology/parameter_slopes.hpp"
#include "steady/uniform_flow.hpp"

namespace talus::steady {

/// What measurements of a steady flow may leave open.
enum class Parameter { mu_s, mu_d, mu_inf, I_0, alpha, mu_w, W, d, Phi, rho_star };
inline constexpr int n_parameters = 10;
inline constexpr std::array<std::string_view, n_parameters> parameter_names{
    "mu_s", "mu_d", "mu_inf", "I_0", "alpha", "mu_w", "W", "d", "Phi", "rho_star"};
inline constexpr std::array<std::string_view, n_parameters> parameter_units{"1", "1", "1", "1", "1",
                                                                            "1", "m", "m", "1", "kg/m3"};
/// Whether a law of this kind has the parameter; all channels have mu_w, W, d, Phi, rho_star.
[[nodiscard]] bool uses(const rheology::Law& law, Parameter parameter);
[[nodiscard]] double value_of(const Channel& channel, Parameter parameter);

using Gradient = std::array<double, n_parameters>;

/// A channel whose parameters may vary.
struct VariedChannel {
  Channel channel;
  bool I_N_follows = false;  ///< I_N is the neutral point of the classical part, wherever that lies

  /// The same with other values. Throws std::invalid_argument where the law or `check` refuses them.
  [[nodiscard]] VariedChannel with(const Gradient& values) const;
  [[nodiscard]] Gradient values() const;
};

/// A number and its exact first derivatives.
struct Sensitivity {
  double value;
  Gradient by;            ///< at fixed slope and depth, per unit of each parameter
  double by_slope;        ///< per unit of tan zeta
  double by_depth = 0.0;  ///< per metre
};

/// Q [kg/s] of a flow of that channel on a heap (no base below it). Precondition: walls, mu_w > 0.
[[nodiscard]] Sensitivity flux_sensitivity(const VariedChannel& varied, const UniformFlow& flow);
/// u [m/s] at `depth` [m] >= 0 below its surface, likewise.
[[nodiscard]] Sensitivity speed_sensitivity(const VariedChannel& varied, const UniformFlow& flow, double depth);
/// I at its surface.
[[nodiscard]] Sensitivity surface_inertial_number(const VariedChannel& varied, const UniformFlow& flow);
/// C (3.18), and q, at its surface.
[[nodiscard]] Sensitivity surface_C(const VariedChannel& varied, const UniformFlow& flow);
[[nodiscard]] Sensitivity surface_q(const VariedChannel& varied, const UniformFlow& flow);

/// The flow that carries Q [kg/s], with the sensitivity of its flux: by Newton's method from the slope of tangent `guess`,
/// to 1e-12 of Q; by `flow_of_flux` where that fails, or where there is no guess. None as there.
struct FlowWithFlux {
  UniformFlow flow;
  Sensitivity flux;
};
[[nodiscard]] Answer<FlowWithFlux> flow_near(const VariedChannel& varied, double Q, std::optional<double> guess);

/// Of something that depends on the slope, along the slope that keeps the flux Q: d/dp = by - by_slope Q_p/Q_slope.
/// `by_slope` is then zero.
[[nodiscard]] Sensitivity at_fixed_flux(const Sensitivity& any, const Sensitivity& flux);

}  // namespace talus::steady
