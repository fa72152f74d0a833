#include "rheology/checks.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "rheology/grains.hpp"

namespace talus::rheology {

namespace checks {

std::string text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

void require(bool ok, const char* law, const char* name, double value, const std::string& expected) {
  if (!ok) throw std::invalid_argument(std::string(law) + ": " + name + " = " + text(value) + " must be " + expected);
}

void within(double low, double high, const char* law, const char* name, double value) {
  require(value >= low && value <= high, law, name, value, "from " + text(low) + " to " + text(high));
}

void friction(const char* law, const char* name, double value) { within(least, most_friction, law, name, value); }

void above(double bound, const char* law, const char* name, double value) {
  require(std::isfinite(value) && value > bound, law, name, value, "finite and above " + text(bound));
}

void no_inverse(const char* law, double mu, const std::string& bound) {
  throw std::domain_error(std::string(law) + ": no inertial number has the friction mu = " + text(mu) + " (" + bound +
                          ")");
}

}  // namespace checks

Grains grains(double rho_star, double Phi, double d) {
  checks::above(0.0, "grains", "rho_star", rho_star);
  checks::above(0.0, "grains", "Phi", Phi);
  checks::require(Phi <= 1.0, "grains", "Phi", Phi, "at most 1");
  checks::above(0.0, "grains", "d", d);
  return {rho_star, Phi, d};
}

}  // namespace talus::rheology
