#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/sparse_pattern.hpp"

namespace talus::core {

enum class Kind : std::uint8_t { differential, algebraic };

/// One physical field among the unknowns. Its equation rows carry the same numbers as its unknowns.
struct Field {
  std::string name;           ///< the symbol of the house, for example "u"
  std::string unit;           ///< SI, for example "m s-1"
  Kind kind;                  ///< differential unknowns enter the error test, algebraic ones do not
  double absolute_tolerance;  ///< in `unit`, for the error test (differential) and Newton's convergence test (both)
  /// In `unit`: what Newton's method may leave in any single unknown, where a mean over all of them is not enough.
  double newton_bound = std::numeric_limits<double>::infinity();
};

/// What each unknown is: `field_of[row]` indexes `fields`.
struct Layout {
  std::vector<Field> fields;
  std::vector<std::uint8_t> field_of;

  [[nodiscard]] Index size() const { return static_cast<Index>(field_of.size()); }
  [[nodiscard]] const Field& field(Index row) const { return fields[field_of[row]]; }
};

}  // namespace talus::core
