#pragma once

#include <span>
#include <string>

#include "core/dae_system.hpp"

namespace talus::ida {

/// What is known when an integration fails.
struct Failure {
  std::string what;  ///< for example "IDA gave up (IDA_CONV_FAIL)"
  double t;          ///< [s]
  double step;       ///< last tried [s]
  int order;
  long steps;
  std::string refusal;  ///< why a state was last refused, or empty
  std::string measure;  ///< what `size` measures, for example "weighted Newton correction"
};

/// The failure in words, with the ten rows of largest `size` (shape n; NaN counts as largest, zeros are left out) by
/// field and place, each with its value in `y`.
[[nodiscard]] std::string report(const Failure& failure, const core::DaeSystem& system, std::span<const double> size,
                                 std::span<const double> y);

}  // namespace talus::ida
