#pragma once

#include "core/field_source.hpp"
#include "two_fluid/two_fluid.hpp"

namespace talus::two_fluid {

/// The two-fluid model's state as named fields, for writers and viewers. Coordinates are those of the box: x down the base, z normal to
/// it. Names that the layer model has, too, mean the same.
class TwoFluidFields final : public core::FieldSource {
 public:
  /// `system` must outlive this.
  explicit TwoFluidFields(const TwoFluid& system) : system_(system) {}

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override;
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  const TwoFluid& system_;
};

}  // namespace talus::two_fluid
