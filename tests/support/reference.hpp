#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "rheology/law.hpp"

/// Reference numbers kept in tests/support/data; each file names its source.
namespace talus::support {

inline nlohmann::json reference(const std::string& file) {
  std::ifstream in(std::string(TALUS_TEST_DATA) + "/" + file);
  if (!in) throw std::runtime_error("no reference file " + file);
  return nlohmann::json::parse(in);
}

inline rheology::Classical classical_of(const nlohmann::json& parameters) {
  return rheology::classical(parameters.at("mu_s"), parameters.at("mu_d"), parameters.at("I_0"));
}
/// With the printed, rounded I_N.
inline rheology::PartiallyRegularised partial_of(const nlohmann::json& parameters) {
  return rheology::partially_regularised(classical_of(parameters), parameters.at("mu_inf"), parameters.at("alpha"),
                                         parameters.at("I_N").get<double>());
}
inline rheology::Grains grains_of(const nlohmann::json& parameters) {
  return rheology::grains(parameters.at("rho_star"), parameters.at("Phi"), parameters.at("d"));
}

}  // namespace talus::support
