#pragma once

#include <vector>

#include "core/field_source.hpp"

namespace talus::app {

/// A model's variables, evaluated once a time for all who select from them.
class EvaluatedFields {
 public:
  /// `source` must outlive this object.
  explicit EvaluatedFields(core::FieldSource& source) : source_(source) {}
  [[nodiscard]] const core::FieldSource& source() const { return source_; }
  /// values[i] of the source's variables()[i]; evaluated anew where the snapshot's time differs from the last one's.
  const std::vector<std::vector<double>>& at(const core::Snapshot& snapshot);

 private:
  core::FieldSource& source_;
  std::vector<std::vector<double>> values_;
  double t_ = 0.0;
  bool empty_ = true;
};

/// `fields`: what has a place, and what is written once; `surface`: of these, coordinates and what has fewer dimensions
/// than the model's fields; `series`: what changes in time and has fewer dimensions than these, lines under their name
/// with "_series" behind; `numbers`: single numbers that change in time.
enum class Selection { fields, surface, series, numbers };

/// The part of a source's variables that a recording wants. Fields are recorded seldom, series often.
class SelectedFields : public core::FieldSource {
 public:
  /// `evaluated` must outlive this object.
  SelectedFields(EvaluatedFields& evaluated, Selection selection);

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override { return variables_; }
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  EvaluatedFields& evaluated_;
  std::vector<core::Variable> variables_;
  std::vector<std::size_t> chosen_;  ///< positions in the source
};

}  // namespace talus::app
