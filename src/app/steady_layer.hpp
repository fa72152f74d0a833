#pragma once

#include <span>
#include <vector>

#include "app/scene.hpp"
#include "column/column.hpp"
#include "layer/layer.hpp"

namespace talus::app {

/// The uniform steady state of a periodic scene as it stands at its end, on its own grid: found by KINSOL on the column, whose rows are the layer
/// model's, and set on a ring of columns as wide as the scene's.
class SteadyLayer {
 public:
  /// Throws core::ConfigError for a scene that is not a uniform layer over a base at rest (model layer or column), core::IntegrationError
  /// where no steady state is found.
  SteadyLayer(const Scene& scene, int n_columns);

  [[nodiscard]] const layer::Layer& layer() const { return layer_; }
  [[nodiscard]] const column::Column& column() const { return column_; }
  /// Of the layer, shape n.
  [[nodiscard]] std::span<const double> state() const { return y_; }
  /// Of each layer [m/s], from the base up.
  [[nodiscard]] const std::vector<double>& speeds() const { return u_; }
  /// Largest row left of the layer's equations over its weight [1].
  [[nodiscard]] double residual() const { return residual_; }
  /// [m]
  [[nodiscard]] double thickness() const { return layer_.parameters().initial.thickness; }
  /// Mean speed over sqrt(g H cos zeta).
  [[nodiscard]] double froude() const;

 private:
  column::Column column_;
  layer::Layer layer_;
  std::vector<double> u_, y_;
  double residual_ = 0.0;
};

}  // namespace talus::app
