#pragma once

#include <Eigen/Core>
#include <map>
#include <span>

#include "core/dae_system.hpp"
#include "modes/mode.hpp"

namespace talus::modes {

/// All modes of a system that repeats itself: n_blocks blocks of unknowns in equal numbers, joined in a ring, and a state that is the same in
/// each. Perturbations of it are plane waves from block to block, each with a small dense problem of its own, at any wavelength:
/// the ring serves only to read the Jacobian.
class PlaneWaves {
 public:
  /// Linearises about (y, y' = 0) at time t [s]; y of shape n. Throws std::invalid_argument where the unknowns are not n_blocks blocks or
  /// where a row reaches halfway round the ring, so that its neighbours cannot be told apart.
  PlaneWaves(const core::DaeSystem& system, double t, std::span<const double> y, core::Index n_blocks);

  [[nodiscard]] core::Index block_size() const { return size_; }
  /// Every mode with a finite rate that advances by `phase` [rad] from block to block, the fastest growing first. Throws
  /// std::runtime_error where the eigenvalues are not found.
  [[nodiscard]] std::vector<Mode> modes(double phase) const;

 private:
  using Matrix = Eigen::MatrixXcd;
  [[nodiscard]] Matrix wave(const std::map<int, Eigen::MatrixXd>& parts, double phase) const;

  core::Index size_;
  std::map<int, Eigen::MatrixXd> stiffness_, mass_;  ///< by distance in blocks
};

}  // namespace talus::modes
