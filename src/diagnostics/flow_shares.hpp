#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "diagnostics/flow_class.hpp"
#include "diagnostics/ill_posedness.hpp"

namespace talus::diagnostics {

/// How much of what flows is ill-posed, by which measure.
struct FlowShares {
  IllPosedness criteria;  ///< of the area
  ClassShares area;
  ClassShares flux;  ///< of the sum of speed times area
};

/// One cell for the shares.
struct FlowCell {
  double I;  ///< [1]
  FlowClass flow_class;
  double area;   ///< [m2], or any measure of that kind; 0 where it does not flow
  double speed;  ///< [m/s]
};

/// Throws std::invalid_argument where an inertial number is negative or not a number in a cell that flows.
[[nodiscard]] FlowShares flow_shares(const rheology::Law& law, std::span<const FlowCell> cells);

/// A share as models offer it to writers, unit 1.
struct ShareNumber {
  std::string name;
  std::string long_name;
  std::function<double(const FlowShares&)> value;
};
/// All of them, by criterion and by class.
[[nodiscard]] std::vector<ShareNumber> share_numbers();

}  // namespace talus::diagnostics
