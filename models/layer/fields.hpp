#pragma once

#include "core/field_source.hpp"
#include "layer/layer.hpp"

namespace talus::layer {

/// The layer model's state as named fields, for writers and viewers. Coordinates are those of the box: x down the base, z
/// normal to it, from the lower end of the base line x = 0; two-dimensional and moving in time. Velocities are Cartesian.
class LayerFields final : public core::FieldSource {
 public:
  /// `layer` must outlive this.
  explicit LayerFields(const Layer& layer) : layer_(layer) {}

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override;
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  const Layer& layer_;
};

}  // namespace talus::layer
