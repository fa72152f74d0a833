#pragma once

#include <span>

#include "rheology/law.hpp"

namespace talus::diagnostics {

/// Shares [1] of an area in which the law is ill-posed at the local I, by three measures.
struct IllPosedness {
  double C_positive;    ///< (3.18): C > 0; conservative where nu = I mu'/mu > 1/2
  double growing;       ///< short waves grow in the frozen-coefficient theory: the true linear measure
  double not_elliptic;  ///< q = mu - I mu'/2 >= 1
};

/// `I` [1] and `area` [m2] of each cell, same shape; give resting cells area 0, for I means little there. All zero
/// where no area flows. Throws std::invalid_argument where the shapes differ, or I is negative or not a number in an
/// area.
[[nodiscard]] IllPosedness ill_posedness(const rheology::Law& law, std::span<const double> I,
                                         std::span<const double> area);

}  // namespace talus::diagnostics
