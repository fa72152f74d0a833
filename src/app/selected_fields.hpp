#pragma once

#include <vector>

#include "core/field_source.hpp"

namespace talus::app {

/// `fields`: what has a place, and what is written once; `surface`: of these, what has at most one dimension; `series`: what changes
/// in time and has at most one dimension, lines under their name with "_series" behind; `numbers`: single numbers that change in time.
enum class Selection { fields, surface, series, numbers };

/// The part of a source's variables that a recording wants. Fields are recorded seldom, series often.
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
