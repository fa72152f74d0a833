#pragma once

#include "app/theory.hpp"
#include "core/field_source.hpp"

namespace talus::app {

/// The exact steady profile that a run is to be compared with, written once: speed and inertial number against depth
/// below the surface. Offers nothing where theory knows no steady state.
class ExactProfile : public core::FieldSource {
 public:
  explicit ExactProfile(const Theory& theory);

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override;
  [[nodiscard]] std::vector<core::Variable> variables() const override;
  void evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) override;

 private:
  std::vector<std::vector<double>>
      values_;  ///< depth, speed, inertial number, shape (n_points) each; empty without a steady state
};

}  // namespace talus::app
