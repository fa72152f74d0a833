#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/integrator.hpp"

namespace talus::core {

enum class Storage : bool { single_precision, double_precision };

/// A variable that a model offers to writers and viewers.
struct Variable {
  std::string name;                     ///< netCDF name, English, for example "inertial_number"
  std::vector<std::string> dimensions;  ///< names, slowest first, without time: {} is a scalar of each record
  std::string unit;                     ///< UDUNITS, "1" for none
  std::string long_name;
  Storage storage = Storage::single_precision;
  bool fixed = false;                               ///< written once, without time
  std::map<std::string, std::string> attributes{};  ///< further CF or SGRID attributes
  std::vector<std::string> flags{};  ///< words for the values 0, 1, ...: flag_values and flag_meanings of CF
};

/// Turns snapshots of the unknowns into named fields. Knows nothing of file formats.
class FieldSource {
 public:
  virtual ~FieldSource() = default;
  /// Dimension names and lengths, time left out.
  [[nodiscard]] virtual std::vector<std::pair<std::string, std::size_t>> dimensions() const = 0;
  [[nodiscard]] virtual std::vector<Variable> variables() const = 0;
  /// `values[i]` belongs to variables()[i], row-major, resized here. NaN marks "no meaning here".
  virtual void evaluate(const Snapshot& snapshot, std::vector<std::vector<double>>& values) = 0;
};

}  // namespace talus::core
