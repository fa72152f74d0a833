#pragma once

#include "core/scalar.hpp"

namespace talus::rheology {

/// I/(I + I_0) of (1.3), from 0 at rest to 1: value and derivative exact to rounding at every I >= 0, with neither
/// cancellation at large I nor a division by zero at rest.
template <class S>
S saturation(const S& I, double I_0) {
  return core::select_above(
      I, I_0, [&] { return S(1.0 / (1.0 + I_0 / I)); }, [&] { return S(I / (I + I_0)); });
}

}  // namespace talus::rheology
