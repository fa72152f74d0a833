#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/field_source.hpp"

namespace talus::support {

/// A small FieldSource for the output tests: one variable of each kind that a writer must know. The values follow
/// value(t, i) below, so that a reader can tell each of them.
class HeapFields : public core::FieldSource {
 public:
  static constexpr std::size_t n_columns = 5;
  static constexpr std::size_t n_layers = 3;
  static double value(double t, std::size_t i) { return 10.0 * t + 0.25 * static_cast<double>(i); }

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override {
    return {{"column", n_columns}, {"layer", n_layers}};
  }

  [[nodiscard]] std::vector<core::Variable> variables() const override {
    const auto single = core::Storage::single_precision;
    const auto twice = core::Storage::double_precision;
    return {{"mesh", {}, "1", "topology", twice, true, {{"cf_role", "grid_topology"}, {"topology_dimension", "2"}}},
            {"x", {"column"}, "m", "distance along the base", twice, true, {{"axis", "X"}}},
            {"speed", {"layer", "column"}, "m s-1", "speed", single, false, {{"coordinates", "x"}}},
            {"height", {"column"}, "m", "height", twice},
            {"mass_stored", {}, "kg", "mass in the box", twice}};
  }

  /// speed is NaN in the first cell and beyond single precision in the second.
  void evaluate(const core::Snapshot& s, std::vector<std::vector<double>>& values) override {
    values.assign(5, {});
    for (std::size_t i = 0; i < n_columns; ++i) {
      values[1].push_back(value(0.0, i));
      values[3].push_back(value(s.t, i));
    }
    for (std::size_t i = 0; i < n_columns * n_layers; ++i) values[2].push_back(value(s.t, i));
    values[2][0] = std::numeric_limits<double>::quiet_NaN();
    values[2][1] = 1e300;
    values[4].assign(1, value(s.t, 0));
  }
};

}  // namespace talus::support
