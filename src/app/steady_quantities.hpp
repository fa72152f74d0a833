#pragma once

#include <span>

#include "app/steady_cases.hpp"

namespace talus::app {

/// A number that a steady flow has once. Named `name` in netCDF files, `name` + `suffix` in JSON, where the suffix is the
/// unit.
struct SteadyQuantity {
  const char* name;
  const char* suffix;
  const char* unit;  ///< UDUNITS
  const char* long_name;
  double (*value)(const SteadyFlow& s);
};
std::span<const SteadyQuantity> steady_quantities();

/// A number that a steady flow has at each depth of its profile; point `i` of `s.depths`.
struct SteadyProfile {
  const char* name;
  const char* suffix;
  const char* unit;
  const char* long_name;
  double (*value)(const SteadyFlow& s, std::size_t i);
};
std::span<const SteadyProfile> steady_profiles();

}  // namespace talus::app
