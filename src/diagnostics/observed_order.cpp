#include "diagnostics/observed_order.hpp"

#include <cmath>
#include <stdexcept>

#include "diagnostics/line_fit.hpp"

namespace talus::diagnostics {

namespace {
std::vector<double> logarithms(std::span<const double> values) {
  std::vector<double> logs;
  for (const double v : values) {
    if (!(v > 0.0 && std::isfinite(v)))
      throw std::invalid_argument("observed order: sizes and errors must be finite and above 0");
    logs.push_back(std::log(v));
  }
  return logs;
}
}  // namespace

std::vector<double> observed_orders(std::span<const double> h, std::span<const double> e) {
  if (h.size() != e.size() || h.size() < 2)
    throw std::invalid_argument("observed order: needs two or more rows, as many h as e");
  const auto log_h = logarithms(h), log_e = logarithms(e);
  std::vector<double> orders;
  for (std::size_t i = 0; i + 1 < h.size(); ++i) {
    if (h[i] == h[i + 1]) throw std::invalid_argument("observed order: two neighbouring sizes are alike");
    orders.push_back((log_e[i] - log_e[i + 1]) / (log_h[i] - log_h[i + 1]));
  }
  return orders;
}

double fitted_order(std::span<const double> h, std::span<const double> e) {
  return fit_line(logarithms(h), logarithms(e)).slope;
}

}  // namespace talus::diagnostics
