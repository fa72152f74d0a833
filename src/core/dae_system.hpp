#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/layout.hpp"
#include "core/sparse_pattern.hpp"

namespace talus::core {

/// A differential-algebraic system F(t, y, y') = 0 of n unknowns. Models implement it; integrators consume it.
class DaeSystem {
 public:
  DaeSystem() = default;
  DaeSystem(const DaeSystem&) = delete;
  DaeSystem& operator=(const DaeSystem&) = delete;
  virtual ~DaeSystem() = default;

  [[nodiscard]] virtual const Layout& layout() const = 0;
  /// Pattern of dF/dy + c_j dF/dy'; frozen for the life of the system.
  [[nodiscard]] virtual const SparsePattern& pattern() const = 0;
  /// State at time t [s] and a guess of its derivative (shape n each); the integrator makes them consistent.
  virtual void initial_state(double t, std::span<double> y, std::span<double> yp) const = 0;
  /// r = F(t, y, y'), shape n. Throws InadmissibleState where the state is outside the model's domain.
  virtual void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const = 0;
  /// values = dF/dy + c_j dF/dy' in the order of pattern(), shape n_nonzeros. Exact to rounding.
  virtual void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                        std::span<double> values) const = 0;
  /// The row in words: field and place, for example "u at face 12, layer 3 (x = 0.024 m)".
  [[nodiscard]] virtual std::string describe(Index row) const = 0;
  /// Times [s], ascending, at which F is not smooth in t: the integrator stops there and starts afresh.
  [[nodiscard]] virtual std::vector<double> breakpoints() const { return {}; }
};

}  // namespace talus::core
