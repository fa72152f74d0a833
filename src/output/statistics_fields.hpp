#pragma once

#include "core/field_source.hpp"

namespace talus::output {

/// The integrator's counters, step and CPU times as scalar variables of each record. The counters run from the start of
/// the integration. Names: n_<counter of core::Statistics>, `order`, `last_step`,
/// `cpu_<residual|jacobian|factor|solve>`.
class StatisticsFields : public core::FieldSource {
 public:
  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override { return {}; }
  [[nodiscard]] std::vector<core::Variable> variables() const override;
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;
};

}  // namespace talus::output
