#pragma once

#include "column/column.hpp"
#include "core/field_source.hpp"

namespace talus::column {

/// The column's state as named fields over its layers, and the numbers of the whole layer, for writers and viewers.
class ColumnFields final : public core::FieldSource {
 public:
  /// `column` must outlive this.
  explicit ColumnFields(const Column& column) : column_(column) {}

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override;
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  const Column& column_;
};

}  // namespace talus::column
