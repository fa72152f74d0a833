#pragma once

#include "core/field_source.hpp"
#include "triangle/triangle.hpp"

namespace talus::triangle {

/// The triangle's surface and budgets as named fields, in the names of the layer model.
class TriangleFields final : public core::FieldSource {
 public:
  /// `triangle` must outlive this.
  explicit TriangleFields(const Triangle& triangle) : triangle_(triangle) {}

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override;
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  const Triangle& triangle_;
};

}  // namespace talus::triangle
