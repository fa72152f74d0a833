#pragma once

#include <memory>

#include "core/dae_system.hpp"
#include "experiment/inflow.hpp"
#include "fv/operator.hpp"
#include "triangle/shape.hpp"

namespace talus::triangle {

using core::Index;

/// What the terms see of one state.
struct Context {
  double inflow = 0.0;         ///< [kg/s]
  double outflow = 0.0;        ///< over the right end [kg/s]
  double outflow_slope = 0.0;  ///< its derivative by the mass [1/s]
};

/// The heap as a triangle that gains what is poured and loses what the exact steady flow carries down its right face. Three
/// ordinary differential equations; rows in kg/s.
class Triangle final : public core::DaeSystem {
 public:
  enum Unknown : Index { mass, mass_in, mass_right, n_unknowns };

  /// Throws std::invalid_argument for parameters outside their domain.
  explicit Triangle(Parameters parameters);

  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return operator_->pattern(); }
  /// An empty box.
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override;
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override;
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override;
  [[nodiscard]] std::string describe(Index row) const override;
  /// The inlet opens and begins to close.
  [[nodiscard]] std::vector<double> breakpoints() const override;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  /// rho W [kg/m2]: mass over area.
  [[nodiscard]] double mass_per_area() const { return parameters_.channel.grains.rho() * parameters_.channel.gap; }
  /// The heap of a mass [kg]. Throws core::InadmissibleState where its apex lies above the inlet.
  template <class S>
  [[nodiscard]] Shape<S> shape(const S& heap) const;
  /// Inflow and outflow for a heap of a mass [kg] at time t [s].
  [[nodiscard]] Context context(double t, double heap) const;

 private:
  Parameters parameters_;
  Frame frame_;
  core::Layout layout_;
  std::unique_ptr<fv::Operator<Context>> operator_;
};

}  // namespace talus::triangle
