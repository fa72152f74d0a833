#pragma once

#include <span>
#include <string>

#include "core/dae_system.hpp"

namespace talus::bridge {

/// What is known when an integrator gives up.
struct Failure {
  std::string what;     ///< one line: library, flag by name, time, counts
  std::string refusal;  ///< why a state was last refused, or empty
  std::string measure;  ///< what `size` measures, for example "weighted Newton correction"
};

/// The failure in words, with the ten rows of largest `size` (shape n; NaN counts as largest, zeros are left out) by
/// field and place, each with its value in `y`.
[[nodiscard]] std::string report(const Failure& failure, const core::DaeSystem& system, std::span<const double> size,
                                 std::span<const double> y);

}  // namespace talus::bridge
