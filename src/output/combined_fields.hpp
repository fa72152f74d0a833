#pragma once

#include <functional>
#include <vector>

#include "core/field_source.hpp"

namespace talus::output {

/// Several sources as one: their variables one after the other, their dimensions united.
class CombinedFields : public core::FieldSource {
 public:
  /// The sources must outlive this object.
  explicit CombinedFields(std::vector<std::reference_wrapper<core::FieldSource>> sources);

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override;
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  std::vector<std::reference_wrapper<core::FieldSource>> sources_;
  std::vector<std::size_t> n_variables_;                  ///< of each source
  std::vector<std::vector<std::vector<double>>> values_;  ///< of each source, kept to reuse their storage
};

}  // namespace talus::output
