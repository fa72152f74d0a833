#include "diagnostics/norms.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace talus::diagnostics {

Norms norms(std::span<const double> e, std::span<const double> weight) {
  if (e.size() != weight.size()) throw std::invalid_argument("norms: field and weights differ in size");
  double total = 0.0, sum = 0.0, squares = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < e.size(); ++i) {
    if (!(weight[i] >= 0.0)) throw std::invalid_argument("norms: a weight is negative or not a number");
    if (weight[i] == 0.0) continue;
    total += weight[i];
    sum += weight[i] * std::abs(e[i]);
    squares += weight[i] * e[i] * e[i];
    if (!(std::abs(e[i]) <= largest)) largest = std::isnan(largest) ? largest : std::abs(e[i]);
  }
  if (total == 0.0) throw std::invalid_argument("norms: nothing to measure");
  return {sum / total, std::sqrt(squares / total), largest};
}

Norms norms(std::span<const double> e) { return norms(e, std::vector<double>(e.size(), 1.0)); }

double relative_l2(std::span<const double> value, std::span<const double> reference, std::span<const double> weight) {
  if (value.size() != reference.size()) throw std::invalid_argument("relative_l2: the fields differ in size");
  std::vector<double> error(value.begin(), value.end());
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= reference[i];
  return norms(error, weight).l2 / norms(reference, weight).l2;
}

}  // namespace talus::diagnostics
