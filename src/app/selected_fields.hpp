#pragma once

#include <vector>

#include "core/field_source.hpp"

namespace talus::app {

/// Which variables of a model go where: what has a place on the grid is recorded at the field times, what is one number at the
/// series times.
enum class Selection { fields, surface, series };

/// The part of a source's variables that a recording wants. `fields`: all with a place, and what is written once; `surface`: of
/// these, those with at most one dimension; `series`: single numbers that change in time.
class SelectedFields : public core::FieldSource {
 public:
  /// `source` must outlive this object.
  SelectedFields(core::FieldSource& source, Selection selection);

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override { return variables_; }
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  core::FieldSource& source_;
  std::vector<core::Variable> variables_;
  std::vector<std::size_t> chosen_;  ///< positions in the source
  std::vector<std::vector<double>> all_;
};

}  // namespace talus::app
