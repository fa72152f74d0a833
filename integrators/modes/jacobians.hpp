#pragma once

#include <span>
#include <vector>

#include "core/dae_system.hpp"

namespace talus::modes {

/// The two matrices of a system linearised about (y, y' = 0), in the order of its pattern.
struct Jacobians {
  std::vector<double> stiffness;  ///< dF/dy
  std::vector<double> mass;       ///< dF/dy'
};

/// From the exact dF/dy + c_j dF/dy' at two c_j.
[[nodiscard]] inline Jacobians jacobians(const core::DaeSystem& system, double t, std::span<const double> y) {
  const std::vector<double> still(y.size(), 0.0);
  Jacobians both{std::vector<double>(system.pattern().n_nonzeros()),
                 std::vector<double>(system.pattern().n_nonzeros())};
  system.jacobian(t, y, still, 0.0, both.stiffness);
  system.jacobian(t, y, still, 1.0, both.mass);
  for (std::size_t i = 0; i < both.mass.size(); ++i) both.mass[i] -= both.stiffness[i];
  return both;
}

}  // namespace talus::modes
