#include "rheology/well_posedness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/bracketed_root.hpp"

namespace talus::rheology {

namespace {

constexpr double smallest_I = 1e-12, largest_I = 1e6, scan_ratio = 1.02;

/// Sign changes of f(I) over the range of the scan. A law whose slope jumps at I_N is scanned on both sides of it.
template <class F>
std::vector<double> sign_changes(const Law& law, F&& f) {
  std::vector<double> grid;
  for (double I = smallest_I; I < largest_I; I *= scan_ratio) grid.push_back(I);
  if (const auto* partial = std::get_if<PartiallyRegularised>(&law)) {
    grid.push_back(partial->I_N);
    grid.push_back(std::nextafter(partial->I_N, 1.0));
    std::sort(grid.begin(), grid.end());
  }
  std::vector<double> roots;
  double left = f(grid.front());
  for (std::size_t i = 1; i < grid.size(); ++i) {
    const double right = f(grid[i]);
    if (std::signbit(left) != std::signbit(right)) roots.push_back(core::bracketed_root(f, grid[i - 1], grid[i]));
    left = right;
  }
  return roots;
}

}  // namespace

Response response(const Law& law, double I) {
  const double mu = friction(law, I);
  const double nu = mu > 0.0 ? I * friction_slope(law, I) / mu : 0.0;
  return {mu, nu, mu * (1.0 - 0.5 * nu)};
}

double condition_C(const Response& r) { return r.q * r.q - 4.0 * r.nu * (1.0 - r.nu); }

double growth(const Response& r, double s) { return -1.0 + (1.0 - r.nu) * (1.0 - s) * (1.0 + s) / (1.0 - r.q * s); }

double max_growth(const Response& r) {
  if (!(std::abs(r.q) < 1.0)) return std::numeric_limits<double>::infinity();
  return -1.0 + 2.0 * std::max(1.0 - r.nu, 0.0) / (1.0 + std::sqrt((1.0 - r.q) * (1.0 + r.q)));
}

double growth_scale(const Grains& grains, const Response& r, double I, double k) {
  const double kd_over_I = k * grains.d / I;
  return r.mu * kd_over_I * kd_over_I / grains.Phi;
}

std::vector<double> neutral_points(const Law& law) {
  return sign_changes(law, [&](double I) { return condition_C(response(law, I)); });
}

std::optional<double> ellipticity_bound(const Law& law) {
  const auto roots = sign_changes(law, [&](double I) { return response(law, I).q - 1.0; });
  return roots.empty() ? std::nullopt : std::optional(roots.front());
}

}  // namespace talus::rheology
