#include "diagnostics/line_fit.hpp"

#include <cmath>
#include <stdexcept>

namespace talus::diagnostics {

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size() || x.size() < 2)
    throw std::invalid_argument("fit_line: needs two or more points, as many x as y");
  const auto n = static_cast<double>(x.size());
  LineFit fit{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    fit.x_mean += x[i] / n;
    fit.y_mean += y[i] / n;
  }
  double xx = 0.0, xy = 0.0, left = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - fit.x_mean) * (x[i] - fit.x_mean);
    xy += (x[i] - fit.x_mean) * (y[i] - fit.y_mean);
  }
  if (!(xx > 0.0)) throw std::invalid_argument("fit_line: the points lie above one another");
  fit.slope = xy / xx;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = y[i] - fit.y_mean - fit.slope * (x[i] - fit.x_mean);
    left += off * off / n;
  }
  fit.rms = std::sqrt(left);
  return fit;
}

}  // namespace talus::diagnostics
