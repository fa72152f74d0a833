#pragma once

#include <optional>
#include <string>

#include "config/problems.hpp"
#include "config/values.hpp"
#include "sweep/design.hpp"
#include "sweep/spacing.hpp"

namespace talus::sweep {

/// One [[axis]] of a sweep file against the key that it varies.
struct AxisTable {
  const config::Values* table;
  const config::Key* key;
  Axis axis;                        ///< without values where the sample is to draw them
  std::optional<Interval> sampled;  ///< where from
  std::string zip;                  ///< "" where it moves on its own
};

/// Checks one table and takes or makes its values. Adds what is wrong to `problems` and returns nothing then.
/// `samples`: whether the file has a sample, so that `count` may be absent.
std::optional<AxisTable> read_axis(const config::Values& table, const config::Schema& scene_schema, bool samples,
                                   config::Problems& problems);

/// The sampled axis' value at a share [1] of its interval, in [0, 1); each integer of an integer key is equally likely
/// where the spacing is linear.
config::Scalar value_at(const AxisTable& axis, double share);

}  // namespace talus::sweep
