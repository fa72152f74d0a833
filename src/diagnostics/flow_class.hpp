#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rheology/well_posedness.hpp"

namespace talus::diagnostics {

/// What becomes of short waves where grains flow.
enum class FlowClass : std::uint8_t {
  capped,      ///< static by the viscosity's cap, as a Newtonian fluid: they decay
  well_posed,  ///< C <= 0: they decay, as (3.18) says
  damped,      ///< C > 0 but nu > 1/2 and q < 1: they decay by linear theory, though (3.18) is not met
  ill_posed    ///< they grow the faster the shorter they are
};
inline constexpr std::size_t n_flow_classes = 4;
inline constexpr std::array<const char*, n_flow_classes> flow_class_words{"capped", "well_posed", "damped",
                                                                          "ill_posed"};
inline constexpr std::array<const char*, n_flow_classes> flow_class_meanings{
    "the cap of the viscosity acts", "C of (3.18) is not positive", "C is positive, but short waves decay",
    "short waves grow"};

/// "0 the cap of the viscosity acts, 1 ...": the numbers that a field of classes holds, in words.
[[nodiscard]] std::string flow_class_legend();
/// The words of the numbers 0, 1, ....
[[nodiscard]] std::vector<std::string> flow_class_flags();

[[nodiscard]] FlowClass flow_class(const rheology::Response& response, bool capped);

/// Largest growth rate of a wave over the square of its wave number [m2/s], by frozen coefficients: eta/rho times
/// rheology::max_growth, -eta/rho where the cap acts; infinite where q >= 1.
[[nodiscard]] double growth_per_square(const rheology::Response& response, bool capped, double eta, double rho);

/// Share [1] of each class in a sum over cells; all zero where the sum is.
using ClassShares = std::array<double, n_flow_classes>;

/// `weight` of each cell, area or flux, zero where nothing flows; same shape as `classes`. Throws std::invalid_argument otherwise, and for a
/// weight that is negative or not a number.
[[nodiscard]] ClassShares class_shares(std::span<const FlowClass> classes, std::span<const double> weight);

}  // namespace talus::diagnostics
