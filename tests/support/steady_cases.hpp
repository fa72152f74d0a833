#pragma once

#include <string>

#include "steady/channel.hpp"
#include "support/reference.hpp"

namespace talus::support {

/// The channel of a set of parameters of steady_uniform.json; law "partial" or "classical".
inline steady::Channel channel_of(const nlohmann::json& parameters, const std::string& law) {
  return {grains_of(parameters),
          law == "partial" ? rheology::Law(partial_of(parameters)) : rheology::Law(classical_of(parameters)),
          parameters.at("W"), parameters.at("mu_w"), parameters.at("g")};
}

/// The same by its name, "T1_table1" or "T2_table2".
inline steady::Channel channel_named(const std::string& name, const std::string& law) {
  const nlohmann::json all = reference("steady_uniform.json");
  for (const auto& each : all.at("cases"))
    if (each.at("name") == name) return channel_of(each.at("parameters"), law);
  throw std::runtime_error("no reference parameters " + name);
}

/// |value/reference - 1|.
inline double off(double value, double reference) {
  return reference == 0.0 ? std::abs(value) : std::abs(value / reference - 1.0);
}

}  // namespace talus::support
